// SPDX-License-Identifier: MIT
#include "server_process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "run_dir/unique_fd.h"
#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

// stdout to a pipe, stderr to a pipe or, for `err_path` -1, where ours goes.
pid_t spawn(std::vector<std::string> arguments, int out, int err) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  if (err >= 0) posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  ::setenv("XDG_CACHE_HOME", SLIPSTITCH_BIN_DIR "/../tests/cache", 1);  // tests calibrate on a busy machine
  pid_t pid = -1;
  EXPECT_EQ(posix_spawn(&pid, pointers[0], &actions, nullptr, pointers.data(), environ), 0) << pointers[0];
  posix_spawn_file_actions_destroy(&actions);
  return pid;
}

std::array<UniqueFd, 2> make_pipe() {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  return {UniqueFd(ends[0]), UniqueFd(ends[1])};
}

int wait_for(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

std::string read_line(int fd) {
  std::string line;
  for (char c = 0; ::read(fd, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

}  // namespace

Finished run_program(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const auto open_file = [&](const char* name) {
    return UniqueFd(::open((folder / name).c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  };
  const UniqueFd out = open_file("out"), err = open_file("err");
  Finished finished;
  finished.code = wait_for(spawn(arguments, out.get(), err.get()));
  finished.out = read_bytes(folder / "out");
  finished.err = read_bytes(folder / "err");
  return finished;
}

ServerProcess::ServerProcess(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{kServer};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::array<UniqueFd, 2> pipe = make_pipe();
  pid_ = spawn(all, pipe[1].get(), -1);
  pipe[1].reset();
  ready_line_ = read_line(pipe[0].get());
}

ServerProcess::~ServerProcess() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  wait();
}

std::string ServerProcess::address_of(const std::string& interface) const {
  const std::string key = " " + interface + "=";
  const std::size_t begin = ready_line_.find(key) + key.size();
  return ready_line_.substr(begin, ready_line_.find(' ', begin) - begin);
}

void ServerProcess::signal(int number) const { ::kill(pid_, number); }

int ServerProcess::wait() {
  const int code = wait_for(pid_);
  pid_ = -1;
  return code;
}

}  // namespace slipstitch::test
