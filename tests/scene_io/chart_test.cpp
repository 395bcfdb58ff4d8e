// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_io/chart_text.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

TEST(Chart, CommentsAndBlanksAreLeftOut) {
  ChartText chart = split_chart("# rib\r\n\n  KP \r\nPK\n#\nKK");
  EXPECT_EQ(chart.rows, (std::vector<std::string>{"KP", "PK", "KK"}));
  EXPECT_EQ(chart.lines, (std::vector<int>{3, 4, 6}));
}

TEST(Chart, LastLineIsCourseOneAndFirstLetterWaleOne) {
  LoadResult result = load_scene_chart("KKK\nPKK\n", "swatch");
  ASSERT_EQ(problems(result), "");
  const Pattern& pattern = std::get<LoadedScene>(result).scene.knit->pattern;
  EXPECT_EQ(pattern.at(1, 1), StitchKind::purl);
  EXPECT_EQ(pattern.at(1, 2), StitchKind::knit);
  EXPECT_EQ(pattern.at(2, 1), StitchKind::knit);
}

TEST(Chart, ProblemsOfRowsNameTheLineOfTheFile) {
  LoadResult result = load_scene_chart("# swatch\nKKK\n\nKQK\n", "swatch");
  const Issues& issues = std::get<Issues>(result);
  ASSERT_EQ(issues.size(), 1u) << issue_lines(issues);
  EXPECT_EQ(issue_line(issues[0]), "knit.chart.rows[1]: is Q in column 2, expected K or P (line 4)");
}

TEST(Chart, SettingsApplyToTheDefaults) {
  LoadResult result = load_scene_chart("KK\nKK\n", "swatch", {"duration_s=0.5", "yarn.radius_m=0.0004"});
  ASSERT_EQ(problems(result), "");
  EXPECT_EQ(std::get<LoadedScene>(result).scene.duration_s, 0.5);
  EXPECT_EQ(std::get<LoadedScene>(result).scene.yarn.radius_m, 0.0004);
}

/// The demo scene is what its bare chart would run as, but for the step, which the file gives in decimals.
TEST(Chart, DefaultsAreTheDemo) {
  std::string rows;
  for (int i = 0; i < 40; ++i) rows += std::string(40, 'K') + "\n";
  LoadResult chart = load_scene_chart(rows, "stockinette-drape");
  LoadResult demo = load_scene_file(SLIPSTITCH_SOURCE_DIR "/scenes/stockinette-drape.json");
  ASSERT_EQ(problems(chart) + problems(demo), "");
  auto& chart_message = std::get<LoadedScene>(chart).message;
  auto& demo_message = std::get<LoadedScene>(demo).message;
  EXPECT_NEAR(chart_message.fixed().time_step_s(), demo_message.fixed().time_step_s(), 1e-8);
  demo_message.mutable_fixed()->set_time_step_s(chart_message.fixed().time_step_s());
  EXPECT_EQ(difference(chart_message, demo_message), "");
}

}  // namespace
}  // namespace slipstitch
