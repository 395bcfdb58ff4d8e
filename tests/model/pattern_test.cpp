// SPDX-License-Identifier: MIT
#include "model/pattern.h"

#include <gtest/gtest.h>

namespace slipstitch {
namespace {

std::string text(const Pattern& pattern, int course) {
  std::string row;
  for (int w = 1; w <= pattern.wales; ++w) row += pattern.at(course, w) == StitchKind::knit ? 'K' : 'P';
  return row;
}

TEST(Pattern, ChartIsReadFromTheBottomAndFromTheLeft) {
  Issues issues;
  const Pattern pattern = pattern_from_chart({"PKKK", "KPKK", "KKPP"}, false, "chart", issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(pattern.courses, 3);
  EXPECT_EQ(pattern.wales, 4);
  EXPECT_EQ(text(pattern, 1), "KKPP");
  EXPECT_EQ(text(pattern, 3), "PKKK");
}

TEST(Pattern, ReportsEveryProblemOfAChart) {
  Issues issues;
  pattern_from_chart({"KKK", "KXKK", "K?"}, false, "knit.chart.rows", issues);
  ASSERT_EQ(issues.size(), 4u);
  EXPECT_EQ(issues[0].path, "knit.chart.rows[1]");
  EXPECT_EQ(issues[0].value, "4 stitches");
  EXPECT_EQ(issues[0].expected, "3 stitches, as in row 0");
  EXPECT_EQ(issues[1].path, "knit.chart.rows[2]");
  EXPECT_EQ(issues[2].value, "X in column 2");
  EXPECT_EQ(issues[3].value, "? in column 2");
}

TEST(Pattern, RefusesWhatIsTooSmall) {
  for (const std::vector<std::string>& rows : std::vector<std::vector<std::string>>{{}, {"KK"}, {"K", "K"}, {"", ""}}) {
    Issues issues;
    const Pattern pattern = pattern_from_chart(rows, false, "chart", issues);
    EXPECT_FALSE(issues.empty());
    EXPECT_TRUE(pattern.cells.empty());
  }
}

TEST(Pattern, GarterIsTheSameFromPresetChartAndWorkedRows) {
  Issues issues;
  const Pattern preset = pattern_from_preset({"garter", 4, 3}, false, "preset", issues);
  const Pattern chart = pattern_from_chart({"PPP", "KKK", "PPP", "KKK"}, false, "chart", issues);
  const Pattern worked = pattern_from_worked_rows({"KKK", "KKK", "KKK", "KKK"}, false, "worked", issues);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(preset.cells, chart.cells);
  EXPECT_EQ(preset.cells, worked.cells);
}

TEST(Pattern, WorkedRowsAreReadInTheDirectionOfWorking) {
  Issues issues;
  const Pattern flat = pattern_from_worked_rows({"KPP", "KPP"}, false, "worked", issues);
  EXPECT_EQ(text(flat, 1), "PPK") << "right side: from the right edge";
  EXPECT_EQ(text(flat, 2), "PKK") << "wrong side: from the left edge, kinds swapped";
  const Pattern round = pattern_from_worked_rows({"KPP", "KPP"}, true, "worked", issues);
  EXPECT_EQ(text(round, 2), "PPK");
  EXPECT_TRUE(issues.empty());
}

TEST(Pattern, PresetsShowWhatTheirNamesSay) {
  Issues issues;
  EXPECT_EQ(text(pattern_from_preset({"rib", 2, 7, 2, 1}, false, "p", issues), 2), "KKPKKPK");
  EXPECT_EQ(text(pattern_from_preset({"seed", 2, 4}, false, "p", issues), 1), "KPKP");
  EXPECT_EQ(text(pattern_from_preset({"seed", 2, 4}, false, "p", issues), 2), "PKPK");
  EXPECT_EQ(text(pattern_from_preset({"reverse_stockinette", 2, 2}, false, "p", issues), 1), "PP");
  EXPECT_TRUE(issues.empty());
  pattern_from_preset({"lace", 1, 0}, false, "knit.preset", issues);
  ASSERT_EQ(issues.size(), 3u);
  EXPECT_EQ(issues[0].path, "knit.preset.name");
  EXPECT_EQ(issues[1].path, "knit.preset.courses");
  EXPECT_EQ(issues[2].path, "knit.preset.wales");
}

TEST(Pattern, FindsTheSmallestRepeat) {
  Issues issues;
  const auto repeat = [&](const PresetSpec& preset) {
    return smallest_repeat(pattern_from_preset(preset, false, "p", issues));
  };
  EXPECT_EQ(repeat({"stockinette", 5, 4}).courses, 1);
  EXPECT_EQ(repeat({"stockinette", 5, 4}).wales, 1);
  EXPECT_EQ(repeat({"garter", 5, 4}).courses, 2);
  EXPECT_EQ(repeat({"garter", 5, 4}).wales, 1);
  EXPECT_EQ(repeat({"rib", 4, 9, 2, 1}).wales, 3);
  EXPECT_EQ(repeat({"seed", 4, 4}).courses, 2);
  const Pattern lone = pattern_from_chart({"KKK", "KPK", "KKK"}, false, "chart", issues);
  EXPECT_EQ(smallest_repeat(lone).courses, 2);
  EXPECT_EQ(smallest_repeat(lone).wales, 2);
}

}  // namespace
}  // namespace slipstitch
