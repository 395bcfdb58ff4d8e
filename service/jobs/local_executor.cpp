// SPDX-License-Identifier: MIT
#include "jobs/local_executor.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <vector>

#include "jobs/worker_environment.h"

namespace slipstitch::jobs {
namespace {

/// posix_spawn's two C structs. All signals at their defaults and unblocked, no descriptor but 0, 1 and 2.
class SpawnPlan {
 public:
  explicit SpawnPlan(const std::string& log_file) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  /// 0 or an errno.
  int spawn(pid_t& pid, const std::string& program, std::vector<std::string> arguments,
            std::vector<std::string> environment) const {
    return posix_spawn(&pid, program.c_str(), &actions_, &attributes_, pointers(arguments).data(),
                       pointers(environment).data());
  }

 private:
  static std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& text : strings) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
  }

  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

WorkerEnd end_of(int wait_status) {
  WorkerEnd end;
  if (WIFSIGNALED(wait_status)) end.signal = WTERMSIG(wait_status);
  if (WIFEXITED(wait_status)) end.exit_code = WEXITSTATUS(wait_status);
  return end;
}

class LocalExecutor : public Executor {
 public:
  explicit LocalExecutor(std::filesystem::path program) : program_(std::move(program)) {}

  Outcome<WorkerInfo> start(const RunDir& dir, const JobInfo& job) override {
    pid_t pid = -1;
    const int failed = SpawnPlan(worker_log(dir).string())
                           .spawn(pid, program_.string(), {program_.string(), "--job-dir", dir.path.string()},
                                  worker_environment(job));
    if (failed != 0)
      return Error{ErrorCode::internal,
                   "WORKER_CRASHED",
                   "cannot start " + program_.string() + ": " + std::strerror(failed),
                   {},
                   {},
                   {}};
    // The child cannot vanish before it is waited for, but it may have ended: then there is nothing to describe.
    WorkerInfo worker = describe_process(pid).value_or(WorkerInfo{pid, 0, current_boot_id(), handle_of(pid)});
    children_[worker.pid] = worker.start_ticks;
    return worker;
  }

  std::optional<WorkerEnd> poll(const WorkerInfo& worker) override {
    if (!is_child(worker)) return worker_alive(worker) ? std::optional<WorkerEnd>() : WorkerEnd{};
    int status = 0;
    const pid_t reaped = ::waitpid(static_cast<pid_t>(worker.pid), &status, WNOHANG);
    if (reaped == 0 || (reaped < 0 && errno == EINTR)) return {};
    children_.erase(worker.pid);
    return reaped > 0 ? end_of(status) : WorkerEnd{};
  }

  void kill(const WorkerInfo& worker) override {
    // The worker leads its own process group; pid and start time make sure that it is still the one we mean.
    if (is_child(worker) || worker_alive(worker)) ::kill(-static_cast<pid_t>(worker.pid), SIGKILL);
  }

 private:
  static std::string handle_of(pid_t pid) { return "local:" + std::to_string(pid); }

  bool is_child(const WorkerInfo& worker) const {
    const auto child = children_.find(worker.pid);
    return child != children_.end() && child->second == worker.start_ticks;
  }

  std::filesystem::path program_;
  std::map<std::int64_t, std::uint64_t> children_;  // pid -> start time
};

}  // namespace

Outcome<std::unique_ptr<Executor>> make_local_executor(const std::filesystem::path& program) {
  if (::access(program.c_str(), X_OK) != 0 || std::filesystem::is_directory(program)) {
    return Error{ErrorCode::failed_precondition,
                 "WORKER_NOT_FOUND",
                 "the worker program " + program.string() + " cannot be executed; give its path with --worker",
                 {},
                 {},
                 {}};
  }
  return std::unique_ptr<Executor>(std::make_unique<LocalExecutor>(program));
}

}  // namespace slipstitch::jobs
