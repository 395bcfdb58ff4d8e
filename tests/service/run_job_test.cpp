// SPDX-License-Identifier: MIT
#include "worker/run_job.h"

#include <gtest/gtest.h>

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
  const Result<RunSummary> summary = run_job(dir);
  ASSERT_TRUE(summary) << summary.error;
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

TEST(JobLock, IsHeldByOneProcessAtATime) {
  const test::TemporaryFolder folder;
  const Result<UniqueFd> first = jobs::lock_job({folder.path()});
  ASSERT_TRUE(first) << first.error;
  EXPECT_FALSE(jobs::lock_job({folder.path()}));
}

}  // namespace
}  // namespace slipstitch
