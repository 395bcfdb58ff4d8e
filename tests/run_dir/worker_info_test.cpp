// SPDX-License-Identifier: MIT
#include "run_dir/worker_info.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace slipstitch::test {
namespace {

TEST(WorkerInfo, ThisProcessIsAlive) {
  const auto worker = describe_process(::getpid());
  ASSERT_TRUE(worker);
  EXPECT_EQ(worker->pid, ::getpid());
  EXPECT_GT(worker->start_ticks, 0u);
  EXPECT_FALSE(worker->boot_id.empty());
  EXPECT_TRUE(worker_alive(*worker));
}

TEST(WorkerInfo, AnotherStartOrBootIsAnotherProcess) {
  WorkerInfo worker = *describe_process(::getpid());
  ++worker.start_ticks;
  EXPECT_FALSE(worker_alive(worker));
  worker = *describe_process(::getpid());
  worker.boot_id = "another";
  EXPECT_FALSE(worker_alive(worker));
  EXPECT_FALSE(describe_process(0));
  EXPECT_FALSE(describe_process(-1));
}

TEST(WorkerInfo, AnUnreapedProcessIsDead) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::pause();
    ::_exit(0);
  }
  const auto worker = describe_process(child);
  ASSERT_TRUE(worker);
  EXPECT_TRUE(worker_alive(*worker));
  ::kill(child, SIGKILL);
  siginfo_t info{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT), 0);  // dead, not reaped
  EXPECT_FALSE(worker_alive(*worker));
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(worker_alive(*worker));
}

// What /proc says of a process can end while it is being read.
TEST(WorkerInfo, AProcessThatEndsWhileItIsLookedAtIsDeadOrAlive) {
  for (int i = 0; i < 300; ++i) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    std::thread reaper([child] { ::waitpid(child, nullptr, 0); });
    for (int look = 0; look < 50; ++look) describe_process(child);
    reaper.join();
    EXPECT_FALSE(describe_process(child));
  }
}

}  // namespace
}  // namespace slipstitch::test
