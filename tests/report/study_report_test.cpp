// SPDX-License-Identifier: MIT
#include "report/study_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/study_columns.h"
#include "report/study_text.h"
#include "support/csv_cells.h"
#include "support/sample_study.h"

namespace slipstitch::test {
namespace {

std::size_t count_in(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(StudyReport, CsvHasARowARung) {
  const std::string csv = study_csv(sample_work_precision());
  const auto lines = lines_of(csv);
  ASSERT_EQ(lines.size(), 10U);
  for (const std::string& line : lines) EXPECT_EQ(cells_of(line).size(), cells_of(lines[0]).size()) << line;
  EXPECT_EQ(cell(csv, 1, "method"), "LINEARISED_EULER");
  EXPECT_EQ(cell(csv, 5, "rung"), "\"SDIRK2 8.33 ms\"");
  EXPECT_EQ(cell(csv, 5, "step_s"), "0.00833333333");
  EXPECT_EQ(cell(csv, 5, "tolerance_m"), "");
  EXPECT_EQ(cell(csv, 5, "position_error_m"), "0.00025");
  EXPECT_EQ(cell(csv, 5, "order"), "2");
  EXPECT_EQ(cell(csv, 5, "factorizations"), "170");
  EXPECT_EQ(cell(csv, 5, "speedup"), "4");  // 0.4 s to 2.5 mm: 4 s to a tenth of that
  EXPECT_EQ(cell(csv, 5, "speedup_extrapolated"), "1");
  EXPECT_EQ(cell(csv, 4, "force_error_n"), "");  // not finite
  EXPECT_EQ(cell(csv, 6, "resolved"), "0");
  EXPECT_EQ(cell(csv, 6, "predictable_until_s"), "0.1");
  EXPECT_EQ(cell(csv, 1, "reference_error_m"), "1e-06");
  EXPECT_EQ(cell(csv, 7, "failed"), "1");
  EXPECT_EQ(cell(csv, 8, "failed"), "0");
  EXPECT_EQ(cell(csv, 8, "wall_s"), "");
  WorkPrecision study = sample_work_precision();
  study.rungs[0].rung = {std::string(kAccuracyMethod), "0.1 mm", 1e-4, AccuracyNumerics{}};
  EXPECT_EQ(cell(study_csv(study), 1, "tolerance_m"), "0.0001");
  EXPECT_EQ(cell(study_csv(study), 1, "step_s"), "");
}

TEST(StudyReport, MarkdownHasTheTablesAndWhatIsMissing) {
  const std::string text = study_markdown(sample_work_precision(), "make it");
  EXPECT_NE(text.find("(error-time.svg)"), std::string::npos);
  EXPECT_NE(text.find("(error-newton.svg)"), std::string::npos);
  EXPECT_NE(text.find("| * | LINEARISED_EULER 8.33 ms | 5 mm | 2.5 mm | 0.5 mm | 1 | end | 0.2 s | x1 | x1 |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| ~2 um |"), std::string::npos) << text;
  EXPECT_NE(text.find("| 0.1 s | 1 min 10 s |"), std::string::npos) << text;
  EXPECT_NE(text.find("| x4 e | x4 e |"), std::string::npos) << text;
  EXPECT_NE(text.find("| 0.2 % | far off | 0.004 % | 48 | 2 | 500 | 170 | 585 | 2.5 MB |"), std::string::npos) << text;
  EXPECT_NE(text.find("- failed: BDF2 16.7 ms: no step converges"), std::string::npos);
  EXPECT_NE(text.find("- not run: BDF2 8.33 ms, BDF2 4.17 ms: did not fit"), std::string::npos);
  EXPECT_EQ(text.find("| BDF2"), std::string::npos);  // no rows of them
  EXPECT_NE(text.find("- **order**: "), std::string::npos);
  EXPECT_EQ(text.find("estimate"), std::string::npos);  // no run has one
  WorkPrecision study = sample_work_precision();
  study.rungs[0].error_estimate_m = 7e-3;
  EXPECT_NE(study_markdown(study, "").find("| 7 mm |"), std::string::npos);
}

TEST(StudyReport, SaysHowItWasMade) {
  const WorkPrecision study = sample_work_precision();
  EXPECT_NE(study_markdown(study, "make it").find("Made by `make it`; do not edit."), std::string::npos);
  EXPECT_NE(study_markdown(study, "make it", "simJobs/a")
                .find("Made by a server as simJobs/a; `make it` makes another such; do not edit."),
            std::string::npos);
  EXPECT_NE(study_page(study, "make it").find("<p>Made by <code>make it</code></p>"), std::string::npos);
  EXPECT_NE(study_page(study, "make it", "simJobs/<a>")
                .find("<p>Made by a server as simJobs/&lt;a&gt;; <code>make it</code> makes another such</p>"),
            std::string::npos);
}

TEST(StudyReport, PageStandsAlone) {
  const std::string page = study_page(sample_work_precision(), "slipstitch study 'a b'");
  for (std::size_t at = page.find("http"); at != std::string::npos; at = page.find("http", at + 1))
    EXPECT_EQ(page.substr(at, 26), "http://www.w3.org/2000/svg");  // a name, nothing that is loaded
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(count_in(page, "<svg "), 2U);
  EXPECT_EQ(count_in(page, "<tr class=\"front\">"), 2U * 6U);
  EXPECT_NE(page.find("slipstitch study &#39;a b&#39;"), std::string::npos);
  EXPECT_NE(page.find("<li>failed: BDF2 16.7 ms: no step converges, &quot;at all&quot;</li>"), std::string::npos);
  EXPECT_EQ(count_in(page, "<td>SDIRK2 8.33 ms</td>"), 2U);
  EXPECT_EQ(count_in(page, "<td>BDF2"), 0U);
  EXPECT_NE(page.find("accuracy against time</title>"), std::string::npos);
}

TEST(StudyReport, PlotsHaveAColourAndAMarkerAMethod) {
  const WorkPrecision study = sample_work_precision();
  for (const StudyAxis axis : {StudyAxis::wall_time, StudyAxis::newton_iterations}) {
    const std::string svg = study_plot(study, axis);
    EXPECT_TRUE(svg.starts_with("<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_NE(svg.find(">LINEARISED_EULER</text>"), std::string::npos);
    EXPECT_NE(svg.find(">SDIRK2</text>"), std::string::npos);
    EXPECT_EQ(svg.find(">BDF2</text>"), std::string::npos);  // nothing to show
    EXPECT_NE(svg.find("SDIRK2 8.33 ms: 0.25 mm"), std::string::npos);
    EXPECT_NE(svg.find(">error of the reference<"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
  EXPECT_NE(study_plot(study, StudyAxis::wall_time).find(">wall time<"), std::string::npos);
  EXPECT_NE(study_plot(study, StudyAxis::newton_iterations).find(">Newton iterations<"), std::string::npos);
}

TEST(StudyReport, PlotsTakeWhatIsExtreme) {
  WorkPrecision study = sample_work_precision();
  for (RungResult& r : study.rungs)
    if (r.errors) r.errors->position_m = 0.0;
  EXPECT_EQ(study_plot(study, StudyAxis::wall_time).find("nan"), std::string::npos);
  EXPECT_NE(study_plot(study, StudyAxis::wall_time).find(">1e-15 m<"), std::string::npos);  // a scale all the same
  study.rungs[0].errors->position_m = std::numeric_limits<double>::infinity();
  study.rungs[1].errors->position_m = std::nan("");
  EXPECT_EQ(study_plot(study, StudyAxis::wall_time).find("nan"), std::string::npos);
  study.rungs.clear();
  EXPECT_NE(study_plot(study, StudyAxis::wall_time).find("nothing to compare"), std::string::npos);
}

TEST(StudyReport, SaysHowGoodTheReferenceIs) {
  WorkPrecision study = sample_work_precision();
  EXPECT_NE(about_reference(study).find("steps of 1 ms (2 min 20 s)"), std::string::npos) << about_reference(study);
  EXPECT_NE(about_reference(study).find(
                "changed by 3 um; by the order that its changes show, 2, its own error is about 1 um."),
            std::string::npos)
      << about_reference(study);
  study.reference.settled = study.reference.extrapolated = false;
  study.reference.out_of_time = true;
  EXPECT_NE(about_reference(study).find("taken to be as large. It has not settled"), std::string::npos);
  EXPECT_NE(about_reference(study).find("no time for more"), std::string::npos);
  study.reference.at_noise = true;
  EXPECT_NE(about_reference(study).find("noise at the start"), std::string::npos);
  study.reference.failure = "it failed";
  EXPECT_NE(about_reference(study).find("no errors: it failed"), std::string::npos);
}

TEST(StudyReport, SaysHowFarMotionCanBePredicted) {
  WorkPrecision study = sample_work_precision();
  EXPECT_NE(about_horizon(study).find("1 of them is too small"), std::string::npos) << about_horizon(study);
  study.rungs[5].predictable_until_s.reset();
  EXPECT_NE(about_horizon(study).find("predictable to the end"), std::string::npos);
  study.horizon_s = 0.2;
  EXPECT_NE(about_horizon(study).find("not predictable beyond 0.2 s"), std::string::npos);
  for (RungResult& r : study.rungs)
    if (r.errors) r.errors->position_m = std::nan("");
  EXPECT_NE(about_horizon(study).find("not compared at all"), std::string::npos);
  study.reference.twin_step_s.reset();
  EXPECT_NE(about_horizon(study).find("not looked at"), std::string::npos);
}

TEST(StudyReport, SaysWhatADigitCosts) {
  WorkPrecision study = sample_work_precision();
  // Along the front 10 mm, 0.1 s; 5, 0.2; 2.5, 0.4; 1, 0.5: ten times less error for five times the time.
  EXPECT_NE(about_digits(study).find("from 10 mm to 1 mm x5."), std::string::npos) << about_digits(study);
  study.digit_factor.reset();
  EXPECT_NE(about_digits(study).find("too short"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
