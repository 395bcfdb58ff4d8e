// SPDX-License-Identifier: MIT
#include <signal.h>

#include <algorithm>
#include <thread>

#include "service_fixture.h"

namespace slipstitch::test {
namespace {

using RestartTest = ServiceTest;

TEST_F(RestartTest, ReattachesToALiveWorkerAfterKill9) {
  start_server();
  const std::string running = must_create(endless_swing(), "running").name();
  const std::string queued = must_create(swing(3, 0.1, 10.0, 1e-2), "queued").name();
  wait_for_frames(running, 3);
  const Received before = stream_all(running);
  const std::vector<std::string> names = list_names();
  const std::uint64_t revision = get(running).revision();
  const WorkerInfo worker = worker_of(running);
  kill_server();
  ASSERT_TRUE(worker_alive(worker));

  start_server();
  EXPECT_EQ(list_names(), names);
  EXPECT_EQ(must_create(endless_swing(), "running").name(), running);
  EXPECT_EQ(get(running).state(), v1::SimJob::RUNNING);
  EXPECT_GT(get(running).revision(), revision);
  EXPECT_EQ(get(queued).state(), v1::SimJob::QUEUED);
  EXPECT_EQ(worker_of(running).pid, worker.pid);
  wait_for_frames(running, static_cast<std::uint32_t>(before.frames.size()) + 2);
  const Received after = stream_all(running);
  EXPECT_TRUE(std::includes(after.frames.begin(), after.frames.end(), before.frames.begin(), before.frames.end(),
                            [](const auto& a, const auto& b) { return a.first < b.first; }));
  for (const auto& [index, frame] : before.frames) EXPECT_EQ(after.frames.at(index), frame);
  EXPECT_EQ(after.frames.rbegin()->first + 1, after.frames.size()) << "without gaps";
  ASSERT_TRUE(cancel(running).ok());
  EXPECT_EQ(wait_for_end(running).state(), v1::SimJob::CANCELLED);
  EXPECT_EQ(wait_for_end(queued).state(), v1::SimJob::SUCCEEDED) << "its turn came";
}

TEST_F(RestartTest, FindsAJobCompleteThatEndedWhileNobodyServed) {
  start_server();
  const std::string name = must_create(swing(5, 60.0, 30.0, 1e-3)).name();
  wait_for_frames(name, 1);
  kill_server();
  while (!has_summary(folder_of(name))) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  start_server();
  EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED);
  EXPECT_EQ(stream_all(name).frames.size(), 1801U);
}

TEST_F(RestartTest, MarksAWorkerLostThatDiedWithTheServer) {
  start_server();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 2);
  const WorkerInfo worker = worker_of(name);
  kill_server();
  ::kill(static_cast<pid_t>(worker.pid), SIGKILL);
  while (worker_alive(worker)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  start_server();
  const v1::SimJob job = wait_for_end(name);
  EXPECT_EQ(job.state(), v1::SimJob::FAILED);
  EXPECT_EQ(details_of(job.error()).infos.at(0).reason(), "WORKER_LOST");
  const Received received = stream_all(name);
  EXPECT_GE(received.frames.size(), 2U);
  EXPECT_EQ(job.progress().frames(), received.frames.size());
  EXPECT_EQ(received.frames.rbegin()->first + 1, received.frames.size()) << "a prefix without gaps";
}

TEST_F(RestartTest, SaysThatItCannotKnowHowAWorkerOfAnEarlierServerEnded) {
  start_server();
  const std::string name = must_create(endless_swing()).name();
  wait_for_frames(name, 2);
  kill_server();
  start_server();
  ASSERT_EQ(get(name).state(), v1::SimJob::RUNNING);
  ASSERT_EQ(::kill(static_cast<pid_t>(worker_of(name).pid), SIGKILL), 0);
  const v1::SimJob job = wait_for_end(name);
  EXPECT_EQ(job.state(), v1::SimJob::FAILED);
  const google::rpc::ErrorInfo info = details_of(job.error()).infos.at(0);
  EXPECT_EQ(info.reason(), "WORKER_LOST");
  EXPECT_NE(job.error().message().find("its end status is unknown: it was started by an earlier server"),
            std::string::npos)
      << job.error().message();
  EXPECT_NE(info.metadata().at("log_tail").find("running " + name), std::string::npos);
}

TEST_F(RestartTest, EveryAcknowledgedJobSurvivesKillsAtAnyTime) {
  std::vector<std::string> acknowledged;
  for (int round = 0; round < 3; ++round) {
    start_server({"--queue", "1000"});
    for (int i = 0; i < 4; ++i) {
      const std::string id = std::to_string(round) + "-" + std::to_string(i);
      acknowledged.push_back(must_create(swing(3, 0.1, 10.0, 1e-2), id).name());
    }
    kill_server();
  }
  start_server({"--queue", "1000"});
  std::vector<std::string> names = list_names();
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, acknowledged) << "each once, ids sorted by time";
  for (const std::string& name : names) EXPECT_EQ(wait_for_end(name).state(), v1::SimJob::SUCCEEDED);
}

TEST_F(RestartTest, RefusesASecondServerOnTheSameData) {
  start_server();
  const Finished second =
      run_program({kServer, "--grpc", "127.0.0.1:0", "--http", "none", "--data-dir", (folder_ / "data").string()});
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.err.find("pid " + std::to_string(server_->pid())), std::string::npos) << second.err;
  EXPECT_EQ(second.out, "");
}

TEST_F(RestartTest, RefusesASecondServerOnTheSamePort) {
  start_server();
  const Finished second = run_program(
      {kServer, "--grpc", server_->address(), "--http", "none", "--data-dir", (folder_ / "other").string()});
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.err.find(server_->address()), std::string::npos) << second.err;
  EXPECT_EQ(std::count(second.err.begin(), second.err.end(), '\n'), 1) << second.err;
}

}  // namespace
}  // namespace slipstitch::test
