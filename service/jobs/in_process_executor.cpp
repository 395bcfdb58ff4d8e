// SPDX-License-Identifier: MIT
#include "jobs/in_process_executor.h"

#include <unistd.h>

#include <atomic>
#include <map>
#include <thread>

namespace slipstitch::jobs {
namespace {

class InProcessExecutor : public Executor {
 public:
  explicit InProcessExecutor(std::function<void(const RunDir&, const JobInfo&)> work) : work_(std::move(work)) {}

  Outcome<WorkerInfo> start(const RunDir& dir, const JobInfo& job) override {
    // start_ticks 0 is no process: after a restart such a worker counts as lost.
    const WorkerInfo worker{::getpid(), 0, current_boot_id(), "in-process:" + std::to_string(++started_)};
    if (const IoError error = write_worker(dir, worker); !error.empty()) return storage_failed(error);
    Task& task = tasks_[worker.handle];
    task.thread = std::jthread([this, dir, job, &task] {
      work_(dir, job);
      task.done = true;
    });
    return worker;
  }

  std::optional<WorkerEnd> poll(const WorkerInfo& worker) override {
    const auto task = tasks_.find(worker.handle);
    if (task == tasks_.end()) return WorkerEnd{};
    if (!task->second.done) return {};
    tasks_.erase(task);
    return WorkerEnd{0, {}};
  }

  void kill(const WorkerInfo& worker) override { tasks_.erase(worker.handle); }

 private:
  struct Task {
    std::atomic<bool> done = false;
    std::jthread thread;
  };

  std::function<void(const RunDir&, const JobInfo&)> work_;
  std::map<std::string, Task> tasks_;
  int started_ = 0;
};

}  // namespace

std::unique_ptr<Executor> make_in_process_executor(std::function<void(const RunDir&, const JobInfo&)> work) {
  return std::make_unique<InProcessExecutor>(std::move(work));
}

}  // namespace slipstitch::jobs
