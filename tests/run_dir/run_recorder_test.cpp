// SPDX-License-Identifier: MIT
#include "run_dir/run_recorder.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "log_bytes.h"

namespace slipstitch::test {
namespace {

RunDir make_run(const TemporaryFolder& folder) {
  Result<RunDir> dir = create_run_dir(folder / "run", {}, "{}", false);
  EXPECT_TRUE(dir) << dir.error;
  return *dir;
}

Progress progress_at(double t) {
  Progress progress;
  progress.t = t;
  progress.duration_s = 2.0;
  return progress;
}

RunSummary succeeded() {
  RunSummary summary;
  summary.status = RunStatus::succeeded;
  return summary;
}

TEST(RunRecorder, WritesTheForcesOfHandlesAsAnArtefact) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  EXPECT_TRUE(list_artefacts(dir).empty());  // nothing for a scene without handles
  hooks.on_reactions(0.25, {Vec3(1.0, -2.0, 0.125), Vec3::Zero()});
  hooks.on_reactions(0.5, {Vec3(1.0 / 3.0, 0.0, 1e-20), Vec3::Zero()});
  EXPECT_EQ(list_artefacts(dir), std::vector<std::string>{"reactions.csv"});
  EXPECT_EQ(read_bytes(dir.report() / "reactions.csv"),
            "t_s,handle,fx_n,fy_n,fz_n\n0.25,0,1,-2,0.125\n0.25,1,0,0,0\n0.5,0,0.333333333,0,1e-20\n0.5,1,0,0,0\n");
}

TEST(RunRecorder, WritesTheWaysOfBodiesAsAnArtefact) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  hooks.on_bodies(0.0, {Vec3(1.0, -2.0, 0.125), Vec3::Zero()});
  hooks.on_bodies(0.25, {Vec3(1.0 / 3.0, 0.0, 0.0), Vec3::Zero()});
  EXPECT_EQ(list_artefacts(dir), std::vector<std::string>{"bodies.csv"});
  EXPECT_EQ(read_bytes(dir.report() / "bodies.csv"),
            "t_s,body,x_m,y_m,z_m\n0,0,1,-2,0.125\n0,1,0,0,0\n0.25,0,0.333333333,0,0\n0.25,1,0,0,0\n");
}

TEST(RunRecorder, StopsTheRunWhereTheArtefactCannotBeWritten) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  std::filesystem::remove(dir.report());
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  hooks.on_reactions(0.25, {Vec3::Zero()});
  EXPECT_TRUE(hooks.should_stop());
  const Result<RunSummary> written = recorder.finish(succeeded());
  ASSERT_TRUE(written) << written.error;
  EXPECT_EQ(written->status, RunStatus::failed);
  EXPECT_NE(written->message.find("reactions.csv"), std::string::npos) << written->message;
}

TEST(RunRecorder, WritesAWholeRun) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  RecorderOptions options;
  options.progress_interval_s = 1e6;
  int shown = 0;
  options.on_progress = [&](const Progress&) { ++shown; };
  RunRecorder recorder(dir, options);
  const RunHooks hooks = recorder.hooks();
  const FrameHeader header = sample_header();
  hooks.on_header(header);
  for (int index = 0; index < 3; ++index) {
    hooks.on_frame(sample_frame(header, index));
    hooks.on_progress(progress_at(0.5 * (index + 1)));
    EXPECT_FALSE(hooks.should_stop());
  }
  EXPECT_EQ(shown, 3);
  EXPECT_EQ(read_progress(dir)->progress.t, 0.5);  // the others came too soon
  FrameLogReader reader(dir.frames());
  EXPECT_EQ(good_prefix(reader), 3);
  EXPECT_EQ(reader.state(), LogState::growing);
  EXPECT_FALSE(has_summary(dir));
  RunSummary summary = succeeded();
  summary.wall_s = 7.0;
  const Result<RunSummary> written = recorder.finish(summary);
  ASSERT_TRUE(written) << written.error;
  EXPECT_EQ(written->status, RunStatus::succeeded);
  EXPECT_EQ(reader.poll(), LogState::ended);
  EXPECT_EQ(read_progress(dir)->progress.t, 1.5);
  EXPECT_EQ(read_progress(dir)->progress.wall_s, 7.0) << "of the whole run";
  EXPECT_EQ(read_summary(dir)->frames, 3);
}

TEST(RunRecorder, StopsOnCancelAndOnTheCallersWish) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  bool wish = false;
  RecorderOptions options;
  options.control_interval_s = 0.0;
  options.should_stop = [&] { return wish; };
  RunRecorder recorder(dir, options);
  const RunHooks hooks = recorder.hooks();
  EXPECT_FALSE(hooks.should_stop());
  wish = true;
  EXPECT_TRUE(hooks.should_stop());
  wish = false;
  EXPECT_FALSE(hooks.should_stop());
  ASSERT_EQ(request_cancel(dir), "");
  EXPECT_TRUE(hooks.should_stop());
  EXPECT_TRUE(hooks.should_stop());  // once cancelled, always
}

TEST(RunRecorder, ALogThatCannotBeMadeFailsTheRun) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  write_bytes(dir.frames(), "occupied");
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  hooks.on_header(sample_header());
  hooks.on_frame(sample_frame(sample_header(), 0));
  EXPECT_TRUE(hooks.should_stop());
  const Result<RunSummary> written = recorder.finish(succeeded());
  ASSERT_TRUE(written) << written.error;
  EXPECT_EQ(read_summary(dir)->status, RunStatus::failed);
  EXPECT_NE(read_summary(dir)->message.find("frames.log"), std::string::npos);
}

constexpr std::size_t kDiskBytes = 20'000;

// In a child whose files may not grow beyond kDiskBytes: what a full disk does. Returns the exit code.
int run_on_a_full_disk(const RunDir& dir) {
  ::signal(SIGXFSZ, SIG_IGN);
  const rlimit limits{kDiskBytes, kDiskBytes};
  if (::setrlimit(RLIMIT_FSIZE, &limits) != 0) return 10;
  RunRecorder recorder(dir);
  const RunHooks hooks = recorder.hooks();
  hooks.on_header(sample_header());
  if (hooks.should_stop()) return 11;
  for (int index = 0; index < 200; ++index) hooks.on_frame(sample_frame(sample_header(), index));
  if (!hooks.should_stop()) return 12;
  const Result<RunSummary> written = recorder.finish(succeeded());
  return written && written->status == RunStatus::failed ? 0 : 13;
}

TEST(RunRecorder, AFullDiskStopsTheRunAndLeavesWholeFrames) {
  const TemporaryFolder folder;
  const RunDir dir = make_run(folder);
  write_log(folder / "empty.log", 0, false);
  const std::size_t header_bytes = read_bytes(folder / "empty.log").size();
  const pid_t child = ::fork();
  if (child == 0) ::_exit(run_on_a_full_disk(dir));
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  FrameLogReader reader(dir.frames());
  EXPECT_EQ(good_prefix(reader), static_cast<int>((kDiskBytes - header_bytes) / kSampleFrameBytes));
  EXPECT_EQ(reader.trailing_bytes(), 0u);
  EXPECT_NE(read_summary(dir)->message.find("frames.log"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::test
