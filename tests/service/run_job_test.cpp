// SPDX-License-Identifier: MIT
#include "worker/run_job.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "jobs/data_dir.h"
#include "run_dir/atomic_file.h"
#include "support/sample_run.h"

namespace slipstitch {
namespace {

// One static step of many Newton iterations.
RunDir stored_catenary(const test::TemporaryFolder& folder) {
  const Result<std::string> scene = read_file(SLIPSTITCH_SOURCE_DIR "/scenes/catenary.json", 1 << 20);
  const JobInfo job{"", "", "", 1, "", utc_now(), "catenary"};
  return *create_run_dir(folder / "run", job, *scene, false);
}

TEST(RunJob, WritesWhatItMeasured) {
  const test::TemporaryFolder folder;
  const RunDir dir = stored_catenary(folder);
  const Result<RunSummary> summary = run_job(dir);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::succeeded) << summary->message;
  const Result<RunSummary> read = read_summary(dir);
  ASSERT_TRUE(read) << read.error;
  EXPECT_EQ(read->scene, "catenary");
  EXPECT_EQ(read->threads, 1);
  EXPECT_NE(read->version, "");
  EXPECT_NE(read->blas, "");
  EXPECT_TRUE(read->peak_memory_bytes);
}

TEST(RunJob, ChoosesTheEffectsOfASceneThatLeavesThemToTheProgram) {
  const test::TemporaryFolder folder;
  const JobInfo job{"", "", "", 1, "", utc_now(), "fall"};
  const RunDir dir = *create_run_dir(folder / "run", job, R"({"yarns": [{"points_m": [0, 0, 0, 0.1, 0, 0, 0.2, 0, 0]}],
    "effects": {"auto": {}}, "duration_s": 0.1})",
                                     false);
  int trials = 0;
  RecorderOptions options;
  options.progress_interval_s = 1e3;
  options.on_progress = [&](const Progress& progress) {
    if (progress.doing.empty()) return;
    ++trials;
    EXPECT_EQ(read_progress(dir)->doing, progress.doing);  // at once
  };
  const Result<RunSummary> summary = run_job(dir, options);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_GT(trials, 2);
  EXPECT_EQ(read_progress(dir)->doing, "simulating");
  EXPECT_EQ(summary->status, RunStatus::succeeded) << summary->message;
  ASSERT_TRUE(summary->effect_choice);
  EXPECT_EQ(summary->effect_choice->verdicts.size(), 13U);  // all that need no parameters, but plasticity
  ASSERT_TRUE(read_summary(dir)->effect_choice);
}

TEST(RunJob, StopsWithinOneNewtonIterationOfACancel) {
  const test::TemporaryFolder folder;
  const RunDir dir = stored_catenary(folder);
  int looks = 0;
  RecorderOptions options;
  options.should_stop = [&] {
    if (++looks == 10) {
      EXPECT_EQ(request_cancel(dir), "");
    }
    return false;
  };
  const Result<RunSummary> summary = run_job(dir, options);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::cancelled);
  EXPECT_EQ(looks, 10) << "the next look, one Newton iteration later, sees the command first";
  EXPECT_LE(summary->newton_iterations, 10);
}

TEST(RunJob, ReportsASceneThatCannotBeReadAsAFailedRun) {
  const test::TemporaryFolder folder;
  const JobInfo job{"", "", "", 1, "", utc_now(), "broken"};
  const RunDir dir = *create_run_dir(folder / "run", job, "{\"yarn\": {\"radius_m\": -1}}", false);
  const Result<RunSummary> summary = run_job(dir);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::failed);
  EXPECT_NE(summary->message.find("radius_m"), std::string::npos) << summary->message;
  EXPECT_TRUE(has_summary(dir));
}

class StudyJob : public ::testing::Test {
 protected:
  static constexpr char kSwing[] = R"({"name": "swing", "yarns": [{"points_m": [0, 0, 0, 0.05, 0, 0, 0.1, 0, 0]}],
    "effects": {"inertia": {}, "gravity": {}, "stretch": {}}, "handles": [{"where": {"yarn_point": {}}}],
    "duration_s": 0.1})";

  RunDir stored(const char* scene = kSwing) const {
    JobInfo job{"simJobs/a", "", "", 1, "", utc_now(), "swing"};
    job.study = StudyWork{true, 0.0};
    return *create_run_dir(folder_ / "run", job, scene, false);
  }
  static std::map<std::string, nlohmann::json> kept(const RunDir& dir) {
    std::map<std::string, nlohmann::json> runs;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(dir.study() / "runs", none))
      if (entry.path().extension() == ".json")
        runs[entry.path().filename()] = nlohmann::json::parse(test::read_bytes(entry.path()));
    return runs;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(StudyJob, GoesOnWhereTheWorkerBeforeItWasKilled) {
  const RunDir dir = stored();
  RecorderOptions stop_early;
  stop_early.should_stop = [&] { return kept(dir).size() >= 3; };
  const Result<RunSummary> stopped = run_job(dir, stop_early);
  ASSERT_TRUE(stopped) << stopped.error;
  EXPECT_EQ(stopped->status, RunStatus::cancelled);
  EXPECT_TRUE(list_artefacts(dir).empty());
  const auto before = kept(dir);
  ASSERT_EQ(before.size(), 3U);
  std::filesystem::remove(dir.summary());  // as if it had been killed

  const Result<RunSummary> ended = run_job(dir);
  ASSERT_TRUE(ended) << ended.error;
  EXPECT_EQ(ended->status, RunStatus::succeeded) << ended->message;
  const auto after = kept(dir);
  EXPECT_GE(after.size(), 22U);
  for (const auto& [file, run] : before) {
    EXPECT_EQ(after.at(file)["wall_s"][0], run["wall_s"][0]) << "not run anew";
    EXPECT_EQ(after.at(file)["summary"], run["summary"]);
  }
  EXPECT_EQ(list_artefacts(dir),
            (std::vector<std::string>{"error-newton.svg", "error-time.svg", "study.csv", "study.html", "study.md"}));
  EXPECT_FALSE(read_progress(dir)->doing.empty());
  EXPECT_GT(read_progress(dir)->share_done, 0.5);
}

TEST_F(StudyJob, StopsWithinOneNewtonIterationOfACancel) {
  const RunDir dir = stored();
  int looks = 0;
  RecorderOptions options;
  options.control_interval_s = 0.0;
  options.should_stop = [&] {
    if (++looks == 10) {
      EXPECT_EQ(request_cancel(dir), "");
    }
    return false;
  };
  const Result<RunSummary> summary = run_job(dir, options);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::cancelled);
  EXPECT_EQ(looks, 10) << "the next look sees the command first";
}

TEST_F(StudyJob, FailsWithItsReportWhereThereIsNoReference) {
  std::string scene = kSwing;
  scene.insert(1, R"("fixed": {"max_newton_iterations": 1, "smallest_step_s": 0.002}, )");
  const RunDir dir = stored(scene.c_str());
  const Result<RunSummary> summary = run_job(dir);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::failed);
  EXPECT_NE(summary->message.find("there is no reference"), std::string::npos) << summary->message;
  EXPECT_EQ(list_artefacts(dir).size(), 5U);
}

TEST_F(StudyJob, ChoosesTheEffectsOfASceneThatLeavesThemToTheProgram) {
  const RunDir dir = stored(R"({"yarns": [{"points_m": [0, 0, 0, 0.1, 0, 0, 0.2, 0, 0]}],
    "handles": [{"where": {"yarn_point": {}}}], "effects": {"auto": {}}, "duration_s": 0.1})");
  const Result<RunSummary> summary = run_job(dir);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::succeeded) << summary->message;
}

TEST_F(StudyJob, FailsWhereThereIsNothingToCompareOrNoPlaceForIt) {
  const RunDir still = stored(R"({"yarns": [{"points_m": [0, 0, 0, 0.1, 0, 0]}], "effects": {"stretch": {}},
    "duration_s": 0})");
  Result<RunSummary> summary = run_job(still);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::failed);
  EXPECT_NE(summary->message.find("nothing can be wrong in it"), std::string::npos) << summary->message;
  std::filesystem::remove_all(still.path);

  const RunDir blocked = stored();
  std::filesystem::remove_all(blocked.report());
  summary = run_job(blocked);
  ASSERT_TRUE(summary) << summary.error;
  EXPECT_EQ(summary->status, RunStatus::failed);
  EXPECT_NE(summary->message.find("report"), std::string::npos) << summary->message;
}

TEST(JobLock, IsHeldByOneProcessAtATime) {
  const test::TemporaryFolder folder;
  const Result<UniqueFd> first = jobs::lock_job({folder.path()});
  ASSERT_TRUE(first) << first.error;
  EXPECT_FALSE(jobs::lock_job({folder.path()}));
}

}  // namespace
}  // namespace slipstitch
