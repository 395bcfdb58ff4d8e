// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "cli/screen/study_table.h"
#include "support/sample_study.h"

namespace slipstitch::test {
namespace {

class StudyCommand : public ::testing::Test {
 protected:
  void SetUp() override { write_bytes(folder_ / "swing.json", swing_scene(0.1)); }
  std::string scene() const { return folder_ / "swing.json"; }
  std::string out() const { return folder_ / "out"; }
  std::vector<std::string> quick(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"study", scene(), "--out", out(), "--quick"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Content of every result that is kept.
  std::map<std::string, std::string> kept() const {
    std::map<std::string, std::string> files;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out" / "runs", none))
      if (entry.path().extension() == ".json") files[entry.path().filename()] = read_bytes(entry.path());
    return files;
  }

  TemporaryFolder folder_;
};

TEST_F(StudyCommand, WritesTheTableInEveryForm) {
  const ProgramEnd end = slipstitch(quick());
  ASSERT_EQ(end.exit_code, 0) << end.err;
  for (const char* part : {"positions", "others", "LINEARISED_EULER\n", "* 16.7 ms", "The reference is SDIRK2",
                           "One more digit costs", "predictable to the end"})
    EXPECT_NE(end.out.find(part), std::string::npos) << part << "\n" << end.out;
  const std::string csv = read_bytes(folder_ / "out" / "study.csv");
  EXPECT_NE(csv.find("\"swing\",\"BDF2 2.08 ms\",BDF2,"), std::string::npos) << csv;
  for (const char* plot : {"error-time.svg", "error-newton.svg"})
    EXPECT_TRUE(read_bytes(folder_ / "out" / plot).starts_with("<svg ")) << plot;
  EXPECT_TRUE(read_bytes(folder_ / "out" / "study.html").starts_with("<!doctype html>"));
  const std::string document = read_bytes(folder_ / "out" / "study.md");
  for (const char* part : {"slipstitch study ", " --quick`", "| SDIRK2 4.17 ms |", "(error-time.svg)"})
    EXPECT_NE(document.find(part), std::string::npos) << part;
}

TEST_F(StudyCommand, PutsSeveralScenesBesideEachOther) {
  write_bytes(folder_ / "longer.json", swing_scene(0.15));
  const ProgramEnd end = slipstitch(quick({folder_ / "longer.json"}));
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const std::string document = read_bytes(folder_ / "out" / "accuracy.md");
  for (const char* part : {"longer.json --out ", "| scene | baseline's error |", "| median |", "0.1 s in ", "0.15 s in ",
                           "](accuracy/swing/error-time.svg)", "](accuracy/longer/error-newton.svg)"})
    EXPECT_NE(document.find(part), std::string::npos) << part << "\n" << document;
  for (const char* stem : {"swing", "longer"})
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "out" / "accuracy" / stem / "study.csv")) << stem;
}

TEST_F(StudyCommand, RefusesTwoScenesOfOneName) {
  std::filesystem::create_directory(folder_ / "other");
  write_bytes(folder_ / "other" / "swing.json", swing_scene(0.15));
  const ProgramEnd end = slipstitch(quick({folder_ / "other" / "swing.json"}));
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.err.find("two scenes are called 'swing'"), std::string::npos) << end.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(StudyCommand, PrintsOneJsonObject) {
  const ProgramEnd end = slipstitch(quick({"--json"}));
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const auto json = nlohmann::json::parse(end.out);
  EXPECT_EQ(json["scene"], "swing");
  EXPECT_EQ(json["finished"], true);
  EXPECT_EQ(json["rungs"].size(), 24U);
  EXPECT_GT(json["rungs"][0]["position_error_m"].get<double>(), json["reference"]["error_m"].get<double>());
  EXPECT_TRUE(json["horizon_s"].is_null());
}

TEST_F(StudyCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(slipstitch({"study", scene()}).exit_code, 2);
  EXPECT_EQ(slipstitch({"study", "--out", out()}).exit_code, 2);
  EXPECT_EQ(slipstitch(quick({"--budget", "0"})).exit_code, 2);
  EXPECT_EQ(slipstitch(quick({"--budget", "soon"})).exit_code, 2);
  EXPECT_EQ(slipstitch(quick({"--set", "yarn.radius_m=-1"})).exit_code, 2);
  const ProgramEnd file = slipstitch({"study", scene(), "--out", scene(), "--force"});
  EXPECT_EQ(file.exit_code, 2);
  EXPECT_NE(file.err.find("not a folder"), std::string::npos) << file.err;
  const ProgramEnd nowhere = slipstitch({"study", scene(), "--out", scene() + "/out"});
  EXPECT_EQ(nowhere.exit_code, 1);
  EXPECT_NE(nowhere.err.find("cannot make"), std::string::npos) << nowhere.err;
  EXPECT_FALSE(std::filesystem::exists(out()));
  std::filesystem::create_directories(out());
  write_bytes(folder_ / "out" / "mine.txt", "x");
  const ProgramEnd occupied = slipstitch(quick());
  EXPECT_EQ(occupied.exit_code, 2);
  EXPECT_NE(occupied.err.find("not empty"), std::string::npos) << occupied.err;
  EXPECT_TRUE(kept().empty());
}

TEST_F(StudyCommand, RunsNothingAgainAndGoesOnWithTheSameSceneOnly) {
  ASSERT_EQ(slipstitch(quick()).exit_code, 0);
  const auto results = kept();
  const std::string csv = read_bytes(folder_ / "out" / "study.csv");
  EXPECT_GE(results.size(), 22U);  // 20 rungs, a reference and its twin
  ASSERT_EQ(slipstitch(quick()).exit_code, 0);
  EXPECT_EQ(kept(), results);
  EXPECT_EQ(read_bytes(folder_ / "out" / "study.csv"), csv);
  const ProgramEnd other = slipstitch(quick({"--set", "duration_s=0.05"}));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("this scene with other contents"), std::string::npos) << other.err;
  const ProgramEnd threads = slipstitch(quick({"--threads", "2"}));
  EXPECT_EQ(threads.exit_code, 2);
  EXPECT_NE(threads.err.find("threads 1"), std::string::npos) << threads.err;
  EXPECT_EQ(kept(), results);
  const ProgramEnd forced = slipstitch(quick({"--set", "duration_s=0.05", "--force"}));
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  for (const auto& [name, content] : kept()) EXPECT_FALSE(results.contains(name)) << name;
}

TEST_F(StudyCommand, GoesOnWhereItWasInterruptedOrKilled) {
  write_bytes(folder_ / "swing.json", swing_scene(1.0, 20));
  const auto stop_with = [&](int signal, std::size_t at_least) {
    Program program("slipstitch", quick());
    wait_until([&] { return kept().size() >= at_least || !program.running(); });
    program.send(signal);
    return program.wait();
  };
  const ProgramEnd interrupted = stop_with(SIGINT, 2);
  EXPECT_EQ(interrupted.exit_code, 130);
  EXPECT_NE(interrupted.err.find("the same command goes on"), std::string::npos) << interrupted.err;
  EXPECT_EQ(interrupted.out, "");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "study.csv"));
  const std::size_t first = kept().size();
  EXPECT_GE(first, 2U);
  EXPECT_EQ(stop_with(SIGKILL, first + 2).signal, SIGKILL);
  const auto before = kept();
  EXPECT_GE(before.size(), first + 2);
  ASSERT_EQ(slipstitch(quick({"--budget", "600"})).exit_code, 0);
  const auto after = kept();
  for (const auto& [name, content] : before) {
    // The first run of each stays; its time may have got company.
    const auto old_run = nlohmann::json::parse(content), new_run = nlohmann::json::parse(after.at(name));
    EXPECT_EQ(new_run["wall_s"][0], old_run["wall_s"][0]);
    EXPECT_EQ(new_run["summary"], old_run["summary"]);
  }
}

TEST_F(StudyCommand, SaysThatNothingFitsOrRuns) {
  const ProgramEnd hurried = slipstitch(quick({"--budget", "1e-9", "--json"}));
  EXPECT_EQ(hurried.exit_code, 1);
  EXPECT_NE(hurried.err.find("no run of it fits into the time"), std::string::npos) << hurried.err;
  EXPECT_EQ(nlohmann::json::parse(hurried.out)["finished"], false);
  const ProgramEnd end =
      slipstitch(quick({"--force", "--set", "fixed={\"max_newton_iterations\": 1, \"smallest_step_s\": 0.002}"}));
  EXPECT_EQ(end.exit_code, 1);  // of all methods only one needs no more than one iteration
  EXPECT_NE(end.err.find("there is no reference"), std::string::npos) << end.err;
  EXPECT_NE(end.out.find("failed: IMPLICIT_EULER"), std::string::npos) << end.out;
}

TEST_F(StudyCommand, ChoosesEffectsWhereTheSceneLeavesThem) {
  const ProgramEnd end = slipstitch(quick({"--set", "effects.auto={}"}));
  EXPECT_EQ(end.exit_code, 0) << end.err;
}

TEST(StudyTable, FitsTerminalsOfEightyColumns) {
  WorkPrecision study = sample_work_precision();
  for (RungResult& r : study.rungs) {
    r.error_estimate_m = 1.23e-4;
    r.rung.method = "IMPLICIT_MIDPOINT";
    if (!r.errors) continue;
    r.errors->position_m = r.errors->most_m = r.errors->rms_m = 1.234e-4;
    r.resolved = false;
    r.newton_iterations = 123456;
    r.cg_iterations = 1234567;
    r.steps = r.factorizations = 12345;
    r.order = -0.074;
    r.wall_s = 72.0;
    r.speedup = Speedup{0.0087, true};
  }
  const std::string text = study_table(study);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  EXPECT_NE(text.find("~0.123 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("estimate"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
