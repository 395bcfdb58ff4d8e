// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace slipstitch::test {
namespace {

class EffectsCommand : public ::testing::Test {
 protected:
  void SetUp() override { write_bytes(folder_ / "swing.json", swing_scene(0.1)); }
  std::string scene() const { return folder_ / "swing.json"; }
  std::string out() const { return folder_ / "out"; }

  TemporaryFolder folder_;
};

TEST_F(EffectsCommand, WritesTheTableInEveryForm) {
  const ProgramEnd end = slipstitch({"effects", scene(), "--out", out(), "--rounds", "1"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  for (const char* part : {"changes by", "costs, with / without", "  gravity", "+ air_drag", "- wind: says nothing"})
    EXPECT_NE(end.out.find(part), std::string::npos) << part << "\n" << end.out;
  EXPECT_NE(read_bytes(folder_ / "out" / "effects.csv").find("\"swing\",gravity,1,"), std::string::npos);
  EXPECT_TRUE(read_bytes(folder_ / "out" / "effects" / "swing.svg").starts_with("<svg "));
  EXPECT_TRUE(read_bytes(folder_ / "out" / "effects.html").starts_with("<!doctype html>"));
  const std::string document = read_bytes(folder_ / "out" / "effects.md");
  for (const char* part : {"slipstitch effects ", "## swing\n", "| gravity | on |", "(effects/swing.svg)",
                           "(effects/swing-growing.svg)", "**self_collision**"})
    EXPECT_NE(document.find(part), std::string::npos) << part;
}

TEST_F(EffectsCommand, PrintsOneJsonObject) {
  const ProgramEnd end = slipstitch({"effects", scene(), "--out", out(), "--rounds", "1", "--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const auto json = nlohmann::json::parse(end.out);
  EXPECT_EQ(json["studies"][0]["scene"], "swing");
  EXPECT_EQ(json["studies"][0]["rounds"], 1);
}

TEST_F(EffectsCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(slipstitch({"effects", scene()}).exit_code, 2);
  EXPECT_EQ(slipstitch({"effects", scene(), "--out", out(), "--rounds", "0"}).exit_code, 2);
  const ProgramEnd nowhere = slipstitch({"effects", scene(), "--out", scene() + "/out"});
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_NE(nowhere.err.find("cannot make"), std::string::npos) << nowhere.err;
  EXPECT_EQ(nowhere.out + nowhere.err.substr(nowhere.err.find('\n') + 1), "");  // at once, and nothing claimed
  const ProgramEnd twice = slipstitch({"effects", scene(), scene(), "--out", out()});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_NE(twice.err.find("'swing'"), std::string::npos) << twice.err;
  const ProgramEnd chosen = slipstitch({"effects", scene(), "--out", out(), "--set", "effects.auto={}"});
  EXPECT_EQ(chosen.exit_code, 2);
  EXPECT_NE(chosen.err.find("effects.auto"), std::string::npos) << chosen.err;
  std::filesystem::create_directories(out());
  write_bytes(folder_ / "out" / "mine.txt", "x");
  const ProgramEnd occupied = slipstitch({"effects", scene(), "--out", out()});
  EXPECT_EQ(occupied.exit_code, 2);
  EXPECT_NE(occupied.err.find("not empty"), std::string::npos) << occupied.err;
  EXPECT_EQ(read_bytes(folder_ / "out" / "mine.txt"), "x");
}

TEST_F(EffectsCommand, SaysWhichSceneDoesNotRun) {
  const ProgramEnd end =
      slipstitch({"effects", scene(), "--out", out(), "--rounds", "1", "--set",
                  "fixed={\"time_step_s\": 0.01, \"max_newton_iterations\": 1, \"smallest_step_s\": 0.009}"});
  EXPECT_EQ(end.exit_code, 1);
  EXPECT_NE(end.err.find("swing does not run"), std::string::npos) << end.err;
}

TEST_F(EffectsCommand, ValidateNamesBodiesThatAreNeverReached) {
  const auto validated = [&](const std::string& y) {
    return slipstitch({"validate", scene(), "--set",
                       "effects.colliders={\"colliders\": [{\"plane\": {\"point_m\": [0, " + y + ", 0]}}]}"})
        .out;
  };
  EXPECT_NE(validated("-5").find("colliders[0] cannot matter here"), std::string::npos) << validated("-5");
  EXPECT_EQ(validated("-0.04").find("cannot matter"), std::string::npos);
  const std::string both = slipstitch({"validate", scene(), "--set", "effects.air_drag={}", "--set", "effects.wind={}",
                                       "--set",
                                       "effects.colliders={\"colliders\": [{\"plane\": {\"point_m\": [0, -5, 0]}}]}"})
                               .out;
  EXPECT_NE(both.find("wind cannot matter here"), std::string::npos) << both;
  EXPECT_NE(both.find("colliders[0] cannot matter here"), std::string::npos) << both;  // still air does no work
}

TEST_F(EffectsCommand, TheChoiceIsMadeOnRequestAndReported) {
  const ProgramEnd end = slipstitch({"simulate", scene(), "--json", "--set", "effects.auto={}"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const auto summary = nlohmann::json::parse(end.out);
  EXPECT_EQ(summary["effect_choice"]["window_s"], 10.0 / 240.0);
  EXPECT_FALSE(summary["effect_choice"]["verdicts"].empty());
  EXPECT_NE(slipstitch({"validate", scene(), "--set", "effects.auto={}"}).out.find("begins by choosing"),
            std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
