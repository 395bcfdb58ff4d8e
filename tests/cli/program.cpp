// SPDX-License-Identifier: MIT
#include "cli/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

namespace slipstitch::test {
namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::vector<std::string>& more) {
  std::vector<std::string> result = more;
  result.push_back("XDG_CACHE_HOME=" SLIPSTITCH_BIN_DIR "/../tests/cache");  // tests calibrate on a busy machine
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (!text.starts_with("SLIPSTITCH_SERVER=") && !text.starts_with("XDG_CACHE_HOME=")) result.emplace_back(*variable);
  }
  return result;
}

void redirect(int to, const std::string& file) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(fd, to);
  ::close(fd);
}

}  // namespace

Program::Program(const std::string& name, const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment) {
  const std::string path = std::string(SLIPSTITCH_BIN_DIR) + "/" + name;
  std::vector<std::string> words = arguments;
  words.insert(words.begin(), name);
  std::vector<std::string> variables = environment_with(environment);
  const std::vector<char*> argv = pointers(words), envp = pointers(variables);
  const std::string out = folder_ / "out", err = folder_ / "err";
  pid_ = ::fork();
  if (pid_ != 0) return;
  redirect(STDIN_FILENO, "/dev/null");
  redirect(STDOUT_FILENO, out);
  redirect(STDERR_FILENO, err);
  ::execve(path.c_str(), argv.data(), envp.data());
  ::_exit(127);
}

Program::~Program() {
  if (!running()) return;
  ::kill(pid_, SIGKILL);
  wait();
}

void Program::send(int signal) const { ASSERT_EQ(::kill(pid_, signal), 0); }

std::string Program::out() const { return read_bytes(folder_ / "out"); }

bool Program::running() {
  if (!reaped_) reaped_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
  return !reaped_;
}

bool Program::blocks(int signal) const {
  const std::string status = read_bytes("/proc/" + std::to_string(pid_) + "/status");
  const std::size_t place = status.find("SigBlk:");
  if (place == std::string::npos) return false;
  const unsigned long long mask = std::strtoull(status.c_str() + place + 7, nullptr, 16);
  return ((mask >> (signal - 1)) & 1U) != 0;
}

ProgramEnd Program::wait() {
  if (!reaped_) ::waitpid(pid_, &status_, 0);
  reaped_ = true;
  ProgramEnd end{-1, 0, out(), read_bytes(folder_ / "err")};
  if (WIFEXITED(status_)) end.exit_code = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) end.signal = WTERMSIG(status_);
  return end;
}

ProgramEnd run_program(const std::string& name, const std::vector<std::string>& arguments,
                       const std::vector<std::string>& environment) {
  return Program(name, arguments, environment).wait();
}

ProgramEnd slipstitch(const std::vector<std::string>& arguments) { return run_program("slipstitch", arguments); }

void wait_until(const std::function<bool()>& condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

std::string swing_scene(double duration_s, int points) {
  nlohmann::ordered_json coordinates = nlohmann::ordered_json::array();
  for (int i = 0; i < points; ++i) {
    for (const double value : {0.01 * i, 0.0, 0.0}) coordinates.push_back(value);
  }
  const nlohmann::ordered_json scene{{"name", "swing"},
                                     {"yarns", {{{"points_m", coordinates}}}},
                                     {"effects",
                                      {{"inertia", nlohmann::ordered_json::object()},
                                       {"gravity", nlohmann::ordered_json::object()},
                                       {"stretch", nlohmann::ordered_json::object()},
                                       {"bending", nlohmann::ordered_json::object()}}},
                                     {"handles", {{{"where", {{"yarn_point", {{"yarn", 0}, {"point", 0}}}}}}}},
                                     {"duration_s", duration_s},
                                     {"frames_per_s", 30.0}};
  return scene.dump(2);
}

}  // namespace slipstitch::test
