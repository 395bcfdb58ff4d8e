// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "formats/formats.h"
#include "run_dir/frame_log.h"
#include "run_dir/run_dir.h"

namespace slipstitch::test {
namespace {

using nlohmann::json;

class Simulate : public ::testing::Test {
 protected:
  void SetUp() override { write_bytes(folder_ / "swing.json", swing_scene(0.2)); }

  std::string scene() const { return folder_ / "swing.json"; }
  std::string out() const { return folder_ / "out"; }
  ProgramEnd run(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"simulate", scene(), "--out", out()});
    return slipstitch(more);
  }
  std::size_t files_in(const std::string& name) const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_ / name), {}));
  }

  TemporaryFolder folder_;
};

TEST_F(Simulate, LeavesAValidRunDirectory) {
  const ProgramEnd end = run({"--threads", "1"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_NE(end.out.find("swing: succeeded"), std::string::npos) << end.out;
  EXPECT_EQ(end.err, "");  // no bar without a terminal
  const Result<RunDir> dir = open_run_dir(out());
  ASSERT_TRUE(dir) << dir.error;
  const Result<RunSummary> summary = read_summary(*dir);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::succeeded);
  EXPECT_EQ(summary->frames, 7);
  EXPECT_EQ(summary->threads, 1);
  EXPECT_FALSE(summary->blas.empty());
  EXPECT_TRUE(summary->peak_memory_bytes.has_value());
  const Result<JobInfo> job = read_job(*dir);
  ASSERT_TRUE(job) << job.error;
  EXPECT_EQ(job->scene_name, "swing");
  EXPECT_EQ(job->spec_hash.size(), 64U);
  FrameLogReader log(dir->frames());
  EXPECT_EQ(log.poll(), LogState::ended);
  EXPECT_EQ(log.num_frames(), 7);
}

TEST_F(Simulate, JsonIsTheSummaryOnDisk) {
  const ProgramEnd end = run({"--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  EXPECT_EQ(json::parse(end.out), json::parse(read_bytes(folder_ / "out" / "summary.json")));
}

TEST_F(Simulate, KeepsNothingWithoutOutButGivesTheSameResult) {
  const json kept = json::parse(run({"--json", "--threads", "1"}).out);
  const ProgramEnd end = slipstitch({"simulate", scene(), "--json", "--threads", "1"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const json lost = json::parse(end.out);
  EXPECT_EQ(lost["state_hash"], kept["state_hash"]);
  EXPECT_EQ(lost["newton_iterations"], kept["newton_iterations"]);
  EXPECT_EQ(files_in(""), 2U);  // the scene and the run that was kept
}

TEST_F(Simulate, SettingsChangeTheScene) {
  const ProgramEnd end = run({"--set", "duration_s=0.1", "--set", "name=short", "--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const json summary = json::parse(end.out);
  EXPECT_EQ(summary["frames"], 4);
  EXPECT_EQ(summary["scene"], "short");
}

TEST_F(Simulate, RunsAgainIntoTheSameFolderOnlyByForce) {
  ASSERT_EQ(run().exit_code, 0);
  const std::string before = read_bytes(folder_ / "out" / "job.json");
  const ProgramEnd refused = run();
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(read_bytes(folder_ / "out" / "job.json"), before);
  EXPECT_EQ(run({"--force"}).exit_code, 0);
  EXPECT_NE(read_bytes(folder_ / "out" / "job.json"), before);
}

TEST_F(Simulate, AFailedRunExitsWithOneAndItsReason) {
  const ProgramEnd end = run({"--set", "fixed.max_newton_iterations=1", "--set", "fixed.smallest_step_s=1e-3", "--set",
                              "fixed.velocity_tolerance_m_per_s=1e-300"});
  EXPECT_EQ(end.exit_code, 1) << end.err;
  EXPECT_NE(end.err.find("the run failed: "), std::string::npos) << end.err;
  EXPECT_NE(end.out.find("swing: failed"), std::string::npos) << end.out;
  const Result<RunSummary> summary = read_summary({out()});
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::failed);
}

TEST_F(Simulate, CtrlCFinishesTheStepAndKeepsAValidRun) {
  write_bytes(folder_ / "long.json", swing_scene(10000.0));
  Program program("slipstitch", {"simulate", folder_ / "long.json", "--out", out(), "--json"});
  FrameLogReader log(folder_ / "out" / "frames.log");
  wait_until([&] {
    log.poll();
    return log.num_frames() >= 3 || !program.running();
  });
  program.send(SIGINT);
  const ProgramEnd end = program.wait();
  EXPECT_EQ(end.exit_code, 130) << end.err;
  EXPECT_EQ(log.poll(), LogState::ended);
  const json summary = json::parse(end.out);
  EXPECT_EQ(summary["status"], "cancelled");
  EXPECT_EQ(summary["frames"], log.num_frames());
  EXPECT_GE(summary["steps"], 8 * (log.num_frames() - 1));
  EXPECT_EQ(summary, json::parse(read_bytes(folder_ / "out" / "summary.json")));
  EXPECT_EQ(slipstitch({"export", out(), "--out", folder_ / "obj", "--format", "obj"}).exit_code, 0);
  EXPECT_EQ(files_in("obj"), static_cast<std::size_t>(log.num_frames()));
}

TEST_F(Simulate, ACancelFromOutsideExitsWithFour) {
  write_bytes(folder_ / "long.json", swing_scene(10000.0));
  Program program("slipstitch", {"simulate", folder_ / "long.json", "--out", out()});
  wait_until([&] { return std::filesystem::exists(folder_ / "out" / "frames.log") || !program.running(); });
  EXPECT_EQ(request_cancel({out()}), "");
  EXPECT_EQ(program.wait().exit_code, 4);
}

TEST_F(Simulate, ExportsEveryFormatThereIs) {
  ASSERT_EQ(run().exit_code, 0);
  for (const Format& format : formats()) {
    const std::string name(format.name);
    const ProgramEnd end = slipstitch({"export", out(), "--out", folder_ / name, "--format", name});
    EXPECT_EQ(end.exit_code, 0) << end.err;
    EXPECT_NE(end.out.find("7 frames as " + name), std::string::npos) << end.out;
    EXPECT_EQ(files_in(name), 7U + (format.collection == nullptr ? 0U : 1U));
    EXPECT_FALSE(read_bytes(folder_ / name / frame_file_name(format, 6)).empty());
  }
  const ProgramEnd part = slipstitch(
      {"export", out(), "--out", folder_ / "part", "--format", "obj", "--first", "2", "--stride", "3", "--json"});
  EXPECT_EQ(json::parse(part.out)["frames"], 2);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "part" / "frame_000005.obj"));
  EXPECT_EQ(slipstitch({"export", out(), "--out", folder_ / "part", "--format", "obj"}).exit_code, 2);
  EXPECT_EQ(slipstitch({"export", out(), "--out", folder_ / "none", "--format", "obj", "--first", "7"}).exit_code, 1);
}

TEST_F(Simulate, ValidateCountsWithoutRunning) {
  const ProgramEnd end = slipstitch({"validate", scene(), "--json"});
  ASSERT_EQ(end.exit_code, 0) << end.err;
  const json found = json::parse(end.out), ran = json::parse(run({"--json"}).out);
  for (const char* key : {"loops", "nodes", "dofs", "effects", "frames"}) EXPECT_EQ(found[key], ran[key]) << key;
  EXPECT_EQ(found["least_steps"], ran["steps"]);
  EXPECT_GT(found["estimated_memory_bytes"], 1'000'000);
  EXPECT_GT(found["estimated_wall_s"], 0.0);
  EXPECT_EQ(found["estimated_steps"], found["least_steps"]);
  const json& to = found.at("to_tolerance").at("runs");
  ASSERT_EQ(to.size(), 3U);
  EXPECT_EQ(to[0].at("tolerance_m"), 1e-3);
  EXPECT_LT(to[0].at("wall_s"), to[2].at("wall_s"));
}

TEST_F(Simulate, ValidateSaysWhatItsTimesRestOn) {
  const std::string guessed = slipstitch({"validate", scene(), "--budget", "0"}).out;
  EXPECT_NE(guessed.find("how a small swatch"), std::string::npos) << guessed;
  EXPECT_NE(guessed.find(" to 0.1 mm"), std::string::npos) << guessed;
  const std::string begun = slipstitch({"validate", scene(), "--budget", "100"}).out;
  EXPECT_EQ(begun.find("how a small swatch"), std::string::npos) << begun;
}

// The demo gives its step, 1/120 s, in decimals that are a little too short: still four a frame.
TEST_F(Simulate, ValidateRoundsStepsAsTheRunDoes) {
  const std::vector<std::string> decimals{"--set", "fixed.time_step_s=0.00833333", "--json"};
  std::vector<std::string> validate{"validate", scene()};
  validate.insert(validate.end(), decimals.begin(), decimals.end());
  const json found = json::parse(slipstitch(validate).out), ran = json::parse(run(decimals).out);
  EXPECT_EQ(found["least_steps"], 24);
  EXPECT_EQ(ran["steps"], 24);
}

TEST_F(Simulate, ValidateGivesNoTimeForStaticScenesThatItCannotTry) {
  const ProgramEnd end =
      slipstitch({"validate", SLIPSTITCH_SOURCE_DIR "/scenes/catenary.json", "--json", "--budget", "0"});
  EXPECT_TRUE(json::parse(end.out).at("estimated_wall_s").is_null()) << end.out;
}

TEST_F(Simulate, ValidateInventsNoStepsWhereTheRunChoosesThem) {
  const std::vector<std::string> asked{"validate", scene(), "--set", "accuracy.tolerance_m=1e-4"};
  const std::string text = slipstitch(asked).out;
  EXPECT_NE(text.find("in as many steps as it takes"), std::string::npos) << text;
  const json found = json::parse(slipstitch({asked[0], asked[1], asked[2], asked[3], "--json"}).out);
  EXPECT_TRUE(found.at("least_steps").is_null()) << found;
  EXPECT_GT(found.at("estimated_wall_s"), 0.0) << found;
}

TEST_F(Simulate, ABudgetIsReported) {
  const json ran = json::parse(run({"--set", "accuracy.budget_s=0.5", "--json"}).out);
  EXPECT_EQ(ran.at("status"), "succeeded");
  EXPECT_EQ(ran.at("budget").at("budget_s"), 0.5);
  EXPECT_EQ(ran.at("budget").at("kept"), ran.at("wall_s").get<double>() <= 1.1 * 0.5);
  EXPECT_GT(ran.at("budget").at("same_tolerance_m"), 0.0);
  EXPECT_GT(ran.at("error_estimate_m"), 0.0);
  const json found = json::parse(slipstitch({"validate", scene(), "--set", "accuracy.budget_s=100", "--json"}).out);
  EXPECT_GT(found.at("budget_tolerance_m"), 0.0) << found;
  EXPECT_GT(found.at("estimated_wall_s"), 0.0) << found;
}

TEST_F(Simulate, ARunWithoutAnEndIsExportedAsFarAsItGoes) {
  ASSERT_EQ(run().exit_code, 0);
  const std::string log = folder_ / "out" / "frames.log";
  std::filesystem::resize_file(log, std::filesystem::file_size(log) - 60);
  const ProgramEnd end = slipstitch({"export", out(), "--out", folder_ / "obj", "--format", "obj"});
  EXPECT_EQ(end.exit_code, 0) << end.err;
  EXPECT_NE(end.err.find("no end yet"), std::string::npos) << end.err;
}

}  // namespace
}  // namespace slipstitch::test
