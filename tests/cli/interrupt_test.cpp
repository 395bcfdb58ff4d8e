// SPDX-License-Identifier: MIT
#include "cli/interrupt.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <future>
#include <thread>

namespace slipstitch::test {
namespace {

// A child that says 'r' when it is ready and 'f' when it has seen the first signal.
struct Child {
  pid_t pid = -1;
  int from_child = -1;

  char next() const {
    char byte = 0;
    return ::read(from_child, &byte, 1) == 1 ? byte : '\0';
  }
  int end() const {
    int status = 0;
    ::waitpid(pid, &status, 0);
    ::close(from_child);
    return status;
  }
};

void say(int pipe, char byte) {
  if (::write(pipe, &byte, 1) != 1) ::_exit(3);
}

// It does not block the signals, and waits for them when this returns.
void start_other_thread() {
  std::promise<void> started;
  const std::future<void> runs = started.get_future();
  std::thread([started = std::move(started)]() mutable {
    started.set_value();
    for (;;) ::pause();
  }).detach();
  runs.wait();
}

// Returns in the child's place never. `other_thread`: one that does not block the signals runs beside.
Child start_child(bool other_thread) {
  int pipe[2];
  if (::pipe(pipe) != 0) return {};
  const pid_t pid = ::fork();
  if (pid != 0) {
    ::close(pipe[1]);
    return {pid, pipe[0]};
  }
  if (other_thread) start_other_thread();
  int first = 0;
  Interrupt interrupt([&] { ++first; });
  say(pipe[1], 'r');
  while (!interrupt.requested()) ::usleep(1000);
  say(pipe[1], first == 1 && interrupt.requested() && first == 1 ? 'f' : 'x');
  for (;;) ::pause();
}

TEST(Interrupt, TheFirstIsSeenAndTheSecondEnds) {
  for (const bool other_thread : {false, true}) {
    for (const int signal : {SIGINT, SIGTERM}) {
      const Child child = start_child(other_thread);
      ASSERT_EQ(child.next(), 'r');
      ASSERT_EQ(::kill(child.pid, signal), 0);
      EXPECT_EQ(child.next(), 'f');
      ASSERT_EQ(::kill(child.pid, signal), 0);
      const int status = child.end();
      EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    }
  }
}

}  // namespace
}  // namespace slipstitch::test
