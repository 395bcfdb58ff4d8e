// SPDX-License-Identifier: MIT
#include "jobs/local_executor.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>

#include "jobs/spawn_program.h"
#include "jobs/worker_environment.h"
#include "run_dir/unique_fd.h"

namespace slipstitch::jobs {
namespace {

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
    const UniqueFd nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    const UniqueFd log(::open(worker_log(dir).c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
    if (!log) return cannot_start(errno_message("cannot write", worker_log(dir)));
    pid_t pid = -1;
    const int failed = spawn_program(pid, {program_.string(), "--job-dir", dir.path.string()}, worker_environment(job),
                                     {nothing.get(), log.get(), log.get()});
    if (failed != 0) return cannot_start(std::strerror(failed));
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
  Error cannot_start(const std::string& why) const {
    return {ErrorCode::internal, "WORKER_CRASHED", "cannot start " + program_.string() + ": " + why, {}, {}, {}};
  }

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
