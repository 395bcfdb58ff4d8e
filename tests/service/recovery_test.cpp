// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <thread>

#include "jobs/local_executor.h"
#include "run_dir/frame_log.h"
#include "store_helpers.h"

namespace slipstitch::jobs {
namespace {

// A worker program for one test: a shell script that knows the job's folder as $2.
std::filesystem::path script(const test::TemporaryFolder& folder, const std::string& body) {
  const std::filesystem::path path = folder / "worker.sh";
  std::ofstream(path) << "#!/bin/sh\ncd \"$2\" || exit 9\n" << body << "\n";
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

std::unique_ptr<Executor> local(const std::filesystem::path& program) {
  Outcome<std::unique_ptr<Executor>> executor = make_local_executor(program);
  EXPECT_TRUE(executor) << executor.error().message;
  return std::move(*executor);
}

// A live process of ours that stands in for a worker; gone when the test is over, however it ends.
class Sleeper {
 public:
  Sleeper() {
    std::string program = "/bin/sleep", time = "1000";
    std::array<char*, 3> arguments{program.data(), time.data(), nullptr};
    EXPECT_EQ(posix_spawn(&pid_, program.c_str(), nullptr, nullptr, arguments.data(), environ), 0);
  }
  ~Sleeper() { kill(); }
  Sleeper(const Sleeper&) = delete;
  Sleeper& operator=(const Sleeper&) = delete;

  pid_t pid() const { return pid_; }
  void kill() {
    if (pid_ < 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_ = -1;
};

JobInfo job_info(const std::string& id) { return {"simJobs/" + id, "r-" + id, "hash", 1, "", utc_now(), "a"}; }

constexpr char kId[] = "01abcdefgh000000";

class RecoveryTest : public ::testing::Test {
 protected:
  RunDir store_job() {
    const Outcome<DataDir> data = DataDir::open(folder_ / "data");
    EXPECT_EQ(data->create_job(kId, job_info(kId), "{}"), "");
    return data->job(kId);
  }
  std::unique_ptr<JobStore> open(std::unique_ptr<Executor> executor) {
    return open_store(folder_ / "data", std::move(executor));
  }

  test::TemporaryFolder folder_;
};

TEST_F(RecoveryTest, RefusesADirectoryInUseNamingItsOwner) {
  HeldWork work;
  auto store = open_store(folder_ / "data", work);
  const Outcome<DataDir> second = DataDir::open(folder_ / "data");
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().reason, "DATA_DIR_IN_USE");
  EXPECT_NE(second.error().message.find(std::to_string(::getpid())), std::string::npos);
}

// As a worker has it that a killed server was just starting.
TEST_F(RecoveryTest, WaitsForALockWhoseOwnerIsDead) {
  ASSERT_TRUE(DataDir::open(folder_ / "data"));
  const pid_t dead = ::fork();
  if (dead == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(dead, nullptr, 0), dead);
  const std::string lock = (folder_ / "data") / "lock";
  std::ofstream(lock) << dead << "\n";
  const int held = ::open(lock.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  std::thread starting([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ::close(held);
  });
  const Outcome<DataDir> data = DataDir::open(folder_ / "data");
  starting.join();
  EXPECT_TRUE(data) << data.error().message;
}

TEST_F(RecoveryTest, KeepsFinishedJobsAndRequestIds) {
  HeldWork work;
  work.let_go();
  std::string id;
  std::uint64_t revision = 0;
  {
    auto store = open_store(folder_ / "data", work);
    id = store->create(new_job("r1"))->id;
    revision = wait_for_end(*store, id).revision;
  }
  auto store = open_store(folder_ / "data", work);
  const Outcome<Job> job = store->get(id);
  ASSERT_TRUE(job);
  EXPECT_EQ(job->state, JobState::succeeded);
  EXPECT_GT(job->revision, revision);
  EXPECT_EQ(store->create(new_job("r1"))->id, id);
  EXPECT_GT(store->create(new_job("r2"))->id, id);
}

TEST_F(RecoveryTest, RunsWhatWasQueued) {
  store_job();
  HeldWork work;
  work.let_go();
  auto store = open_store(folder_ / "data", work);
  EXPECT_EQ(wait_for_end(*store, kId).state, JobState::succeeded);
}

TEST_F(RecoveryTest, MarksALostWorker) {
  const RunDir dir = store_job();
  ASSERT_EQ(write_worker(dir, {::getpid(), 1, current_boot_id(), "local:1"}), "");  // our pid, another start time
  HeldWork work;
  auto store = open_store(folder_ / "data", work);
  const Outcome<Job> job = store->get(kId);
  ASSERT_EQ(job->state, JobState::failed);
  EXPECT_EQ(job->failure->reason, "WORKER_LOST");
  EXPECT_TRUE(has_summary(dir));
}

TEST_F(RecoveryTest, CountsTheFramesOfALostWorkerInItsLog) {
  const RunDir dir = store_job();
  const FrameHeader header = test::sample_header();
  auto log = FrameLogWriter::create(dir.frames());
  ASSERT_TRUE(log) << log.error;
  ASSERT_EQ(log->append_header(header), "");
  for (int i = 0; i < 5; ++i) ASSERT_EQ(log->append_frame(test::sample_frame(header, i)), "");
  Progress progress;
  progress.frames = 2;  // written before the last frames
  ASSERT_EQ(write_progress(dir, {progress, {}, utc_now()}), "");
  ASSERT_EQ(write_worker(dir, {::getpid(), 1, current_boot_id(), "local:1"}), "");
  HeldWork work;
  for (const char* server : {"the one that finds it lost", "the next one"}) {
    EXPECT_EQ(open_store(folder_ / "data", work)->get(kId)->progress->progress.frames, 5) << server;
  }
}

TEST_F(RecoveryTest, BelievesTheSummaryOfAWorkerThatEndedMeanwhile) {
  const RunDir dir = store_job();
  ASSERT_EQ(write_worker(dir, {::getpid(), 1, current_boot_id(), "local:1"}), "");
  RunSummary summary;
  summary.status = RunStatus::succeeded;
  ASSERT_EQ(write_summary(dir, summary), "");
  HeldWork work;
  EXPECT_EQ(open_store(folder_ / "data", work)->get(kId)->state, JobState::succeeded);
}

TEST_F(RecoveryTest, FollowsALiveWorkerToItsEnd) {
  const RunDir dir = store_job();
  Sleeper sleeper;
  ASSERT_EQ(write_worker(dir, *describe_process(sleeper.pid())), "");
  auto store = open(local("/bin/false"));
  EXPECT_EQ(store->get(kId)->state, JobState::running);
  sleeper.kill();
  EXPECT_EQ(wait_for_end(*store, kId).failure->reason, "WORKER_LOST");
}

TEST_F(RecoveryTest, LeavesAlonePartsOfAJobThatWasNeverAcknowledged) {
  std::filesystem::create_directories(folder_ / "data" / "tmp" / kId);
  std::filesystem::create_directories(folder_ / "data" / "jobs" / "01abcdefgh000001");
  Outcome<DataDir> data = DataDir::open(folder_ / "data");
  std::vector<std::string> warnings;
  HeldWork work;
  JobStore store(std::move(*data), StoreOptions(), make_in_process_executor(std::ref(work)), warnings);
  EXPECT_EQ(store.list({})->jobs.size(), 0U);
  EXPECT_EQ(warnings.size(), 1U);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "data" / "tmp" / kId));
}

TEST_F(RecoveryTest, ReportsASignalWithTheLastLinesOfTheLog) {
  auto store = open(local(script(folder_, "i=0; while [ $i -lt 30 ]; do i=$((i+1)); echo line $i; done; kill -9 $$")));
  const Job job = wait_for_end(*store, store->create(new_job("r"))->id);
  ASSERT_TRUE(job.failure);
  EXPECT_EQ(job.failure->reason, "WORKER_CRASHED");
  EXPECT_NE(job.failure->message.find("SIGKILL"), std::string::npos);
  ASSERT_EQ(job.failure->log_tail.size(), 20U);
  EXPECT_EQ(job.failure->log_tail.back(), "line 30");
}

TEST_F(RecoveryTest, ReportsAnExitCode) {
  auto store = open(local(script(folder_, "echo out of luck >&2; exit 7")));
  const Job job = wait_for_end(*store, store->create(new_job("r"))->id);
  ASSERT_TRUE(job.failure);
  EXPECT_NE(job.failure->message.find("exit code 7"), std::string::npos);
  EXPECT_EQ(job.failure->log_tail, std::vector<std::string>{"out of luck"});
}

TEST_F(RecoveryTest, GivesTheWorkerThreadsOfTheJobAndNoDescriptors) {
  auto store = open(local(script(folder_, "echo $OPENBLAS_NUM_THREADS; ls /proc/self/fd | wc -l; kill -9 $$")));
  const Job job = wait_for_end(*store, store->create(new_job("r", "{}", 5))->id);
  ASSERT_TRUE(job.failure);
  // 0, 1, 2 and the folder that ls reads.
  EXPECT_EQ(job.failure->log_tail, (std::vector<std::string>{"5", "4"}));
}

// The server was killed after it had started the worker and before worker.json told anybody.
TEST_F(RecoveryTest, NeverRunsAJobTwiceAtATime) {
  const RunDir dir = store_job();
  Sleeper sleeper;
  const std::string worker = to_json(*describe_process(sleeper.pid())).dump();
  // Stands in for a second worker that finds the job locked while the first one writes worker.json at last.
  auto store = open(local(script(folder_, "echo '" + worker + "' > worker.json; touch tried; exit 75")));
  wait_until(*store, kId, [&](const Job&) { return std::filesystem::exists(dir.path / "tried"); });
  for (int polls = 0; polls < 20; ++polls) {
    ASSERT_EQ(store->get(kId)->state, JobState::running);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  sleeper.kill();
  EXPECT_EQ(wait_for_end(*store, kId).failure->reason, "WORKER_LOST");
}

TEST(LocalExecutor, RefusesAProgramThatIsNone) {
  const auto executor = make_local_executor("/nonexistent/slipstitch-worker");
  ASSERT_FALSE(executor);
  EXPECT_NE(executor.error().message.find("--worker"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::jobs
