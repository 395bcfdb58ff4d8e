// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_io/convert.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

Scene with(const Settings& settings) {
  LoadResult result = load_scene_json(good_scene(), settings);
  EXPECT_EQ(problems(result), "");
  return problems(result).empty() ? std::get<LoadedScene>(result).scene : Scene{};
}

TEST(Settings, ReplaceAndCreate) {
  Scene scene = with({"name=blue swatch", "duration_s=0.25", "yarn.radius_m=0.0004", "effects.gravity={}",
                      "effects.gravity.acceleration_m_per_s2=[0, -1, 0]"});
  EXPECT_EQ(scene.name, "blue swatch");
  EXPECT_EQ(scene.duration_s, 0.25);
  EXPECT_EQ(scene.yarn.radius_m, 0.0004);
  EXPECT_EQ(scene.effects.gravity->acceleration_m_per_s2.y(), -1.0);
}

TEST(Settings, ReachIntoArraysAndAppend) {
  Scene scene = with({"knit.chart.rows[1]=KK", "handles[0].where.corner=TOP_LEFT", "handles[1].where.edge=\"BOTTOM\"",
                      "handles[0].where.corner=TOP_RIGHT"});
  EXPECT_EQ(scene.knit->pattern.at(1, 1), StitchKind::knit);
  ASSERT_EQ(scene.handles.size(), 2u);
  EXPECT_EQ(std::get<Corner>(scene.handles[0].where), Corner::top_right);
  EXPECT_EQ(std::get<Edge>(scene.handles[1].where), Edge::bottom);
}

TEST(Settings, TakeThePlaceOfAnotherChoiceInTheFile) {
  const std::string text = good_scene(R"(, "fixed": {"time_step_s": 0.001})");
  LoadResult result = load_scene_json(text, {"accuracy.tolerance_m=1e-4"});
  ASSERT_EQ(problems(result), "");
  EXPECT_EQ(std::get<AccuracyNumerics>(std::get<LoadedScene>(result).scene.numerics).tolerance_m, 1e-4);
  result = load_scene_json(good_scene(R"(, "accuracy": {"tolerance_m": 1e-4})"), {"accuracy.budget_s=60"});
  ASSERT_EQ(problems(result), "");
  const LoadedScene& loaded = std::get<LoadedScene>(result);
  EXPECT_EQ(std::get<BudgetNumerics>(loaded.scene.numerics).budget_s, 60.0);
  EXPECT_EQ(loaded.message.accuracy().budget_s(), 60.0);
  EXPECT_EQ(message_from_scene(loaded.scene).accuracy().budget_s(), 60.0);
  const std::string both = problems(load_scene_json(good_scene(), {"accuracy.tolerance_m=1e-4", "fixed={}"}));
  EXPECT_NE(both.find("a second choice"), std::string::npos) << both;
}

TEST(Settings, BadOnesAreRefused) {
  const std::vector<std::pair<std::string, std::string>> table{
      {"duration_s", "is the setting \"duration_s\", expected PATH=VALUE"},
      {"=3", "is the setting \"=3\", expected PATH=VALUE"},
      {"a..b=3", "expected PATH=VALUE"},
      {"a[x]=3", "expected PATH=VALUE"},
      {"[0]=3", "expected PATH=VALUE"},
      {"handles[1].where.all={}", "an index may be at most the array's length"},
      {"knit.chart.rows[0].x=3", "a path through objects and arrays"},
      {"yarn.radiusM=3", "did you mean \"radius_m\"?"},
      {"yarn.radius_m=thick", "yarn.radius_m: is \"thick\", expected a finite number, not a string"},
      {"yarn.radius_m=NaN", "yarn.radius_m: is \"NaN\", expected a finite number, not a string"},
      {"yarn.radius_m=null", "yarn.radius_m: is null, expected a finite number; leave"},
      {"yarn={\"radius_m\": 1, \"radius_m\": 2}", "yarn: is "},
  };
  for (const auto& [setting, fragment] : table) {
    std::string text = problems(load_scene_json(good_scene(), {setting}));
    EXPECT_NE(text.find(fragment), std::string::npos) << setting << ": " << text;
    EXPECT_EQ(text.find("line"), std::string::npos) << "not in the file: " << text;
  }
}

}  // namespace
}  // namespace slipstitch
