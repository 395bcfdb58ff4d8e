// SPDX-License-Identifier: MIT
#include "report/effect_report.h"

#include <gtest/gtest.h>

#include "report/effect_columns.h"
#include "report/number_text.h"
#include "report/svg.h"
#include "support/csv_cells.h"

namespace slipstitch::test {
namespace {

EffectStudy sample_study() {
  EffectStudy study;
  study.scene = "a <b> & \"c\"";
  study.radius_m = 5e-4;
  study.duration_s = 0.4;
  study.rounds = 3;
  study.repeatable = true;
  study.itself = {2.0, 1e6, 300, 4000, 96, 321, 330, 400, 2e-4, 0.5, 0.25};
  EffectPrice wrapping;
  wrapping.effect = "wrapping";
  wrapping.listed = true;
  wrapping.max_displacement_m = 6.25e-3;
  wrapping.rms_displacement_m = 1e-3;
  wrapping.time_ratio = 1.25;
  wrapping.with = study.itself;
  wrapping.without = {1.6, 5e5, 300, 2000, 96, 214, 220, 300, 1e-4, 0.25, 0.125};
  EffectPrice sliding = wrapping;
  sliding.effect = "sliding";
  sliding.together = {"contact_length", "sliding_friction"};
  EffectPrice drag = wrapping;
  drag.effect = "air_drag";
  drag.listed = false;
  drag.time_ratio = 0.5;
  EffectPrice stretch;
  stretch.effect = "stretch";
  stretch.listed = true;
  stretch.not_compared = "without it: no step converges, \"at all\"";
  study.prices = {wrapping, sliding, drag, stretch};
  return study;
}

std::vector<EffectReport> sample_reports(const std::string& picture = "<svg id=\"picture\"></svg>") {
  return {{sample_study(), "stem", picture}};
}

TEST(EffectReport, CsvHasBothSidesOfEveryComparison) {
  const std::string csv = effect_csv(sample_reports());
  const auto lines = lines_of(csv);
  ASSERT_EQ(lines.size(), 5U);
  for (const std::string& line : lines) EXPECT_EQ(cells_of(line).size(), cells_of(lines[0]).size()) << line;
  EXPECT_EQ(cell(csv, 1, "effect"), "wrapping");
  EXPECT_EQ(cell(csv, 1, "listed"), "1");
  EXPECT_EQ(cell(csv, 3, "listed"), "0");
  EXPECT_EQ(cell(csv, 2, "together"), "contact_length sliding_friction");
  EXPECT_EQ(cell(csv, 1, "max_displacement_m"), "0.00625");
  EXPECT_EQ(cell(csv, 1, "max_displacement_radii"), "12.5");
  EXPECT_EQ(cell(csv, 1, "rms_displacement_radii"), "2");
  EXPECT_EQ(cell(csv, 1, "with_newton_iterations"), "321");
  EXPECT_EQ(cell(csv, 1, "with_factorizations"), "330");
  EXPECT_EQ(cell(csv, 1, "without_cg_iterations"), "300");
  EXPECT_EQ(cell(csv, 1, "without_newton_iterations"), "214");
  EXPECT_EQ(cell(csv, 4, "time_ratio"), "");
  EXPECT_EQ(cell(csv, 1, "time_ratio"), "1.25");
}

TEST(EffectReport, MarkdownHasARowAnEffectAndSaysWhatIsNotCompared) {
  const std::string text = effect_markdown(sample_reports(), "make it");
  EXPECT_NE(text.find("![What every effect changes and costs](effects/stem.svg)"), std::string::npos);
  EXPECT_NE(text.find("](effects/stem-growing.svg)"), std::string::npos);
  EXPECT_EQ(effect_markdown(sample_reports(""), "make it").find("growing.svg"), std::string::npos);
  EXPECT_NE(
      text.find("| wrapping | on | 12.5 | 2.00 | 0.250 | 0.125 | 100 | 1.25 | 2.00 | 1.00 | 2.00 | 1.50 | 1.50 | 1.33 |"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("| sliding (and contact_length, sliding_friction) | on |"), std::string::npos);
  EXPECT_NE(text.find("| air_drag | added |"), std::string::npos);
  EXPECT_NE(text.find("- `stretch`: without it: no step converges"), std::string::npos);
}

TEST(EffectReport, PlotShowsTheNumbersAndEscapesNames) {
  const std::string svg = effect_plot(sample_study());
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
  for (const char* text : {">12.5<", ">x1.25<", ">x0.500<", ">air_drag (added)<", "without it: no step converges"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
}

TEST(EffectReport, PageStandsAlone) {
  const std::string page = effect_page(sample_reports(), "slipstitch effects 'a b'");
  for (std::size_t at = page.find("http"); at != std::string::npos; at = page.find("http", at + 1))
    EXPECT_EQ(page.substr(at, 26), "http://www.w3.org/2000/svg");  // a name, nothing that is loaded
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("slipstitch effects &#39;a b&#39;"), std::string::npos);
  EXPECT_NE(page.find("<td>12.5</td>"), std::string::npos);
  EXPECT_NE(page.find("<td class=\"why\""), std::string::npos);
  EXPECT_NE(page.find("<svg id=\"picture\">"), std::string::npos);
  EXPECT_NE(page.find("what every effect changes and costs</title>"), std::string::npos);
}

TEST(EffectReport, CellsAreShortAndNeverHideAChange) {
  EXPECT_EQ(cell_text(0.0), "0");
  EXPECT_EQ(cell_text(-1.234567), "-1.23");
  EXPECT_EQ(cell_text(4.2e-5), "4e-05");
  EXPECT_EQ(cell_text(12345.6), "12346");
  EXPECT_EQ(cell_text(std::nan("")), "-");
  EXPECT_EQ(plain_number(100.0), "100");
  EXPECT_EQ(plain_number(0.0123), "0.0123");
}

}  // namespace
}  // namespace slipstitch::test
