// SPDX-License-Identifier: MIT
#include <chrono>

#include "jobs/job_store.h"

namespace slipstitch::jobs {
namespace {

constexpr auto kPollInterval = std::chrono::milliseconds(25);

}  // namespace

void JobStore::schedule() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    Calls calls;
    poll_workers(calls);
    start_workers(calls);
    if (!calls.empty()) {
      lock.unlock();
      for (const auto& call : calls) call();
      lock.lock();
    }
    const auto asked = [this] { return stopping_ || new_work_; };
    if (count(JobState::running) > 0) {
      work_.wait_for(lock, kPollInterval, asked);
    } else {
      work_.wait(lock, asked);
    }
    new_work_ = false;
  }
}

void JobStore::poll_workers(Calls& calls) {
  for (auto& [id, record] : jobs_) {
    if (record.job.state == JobState::running) poll_worker(record, calls);
  }
}

void JobStore::poll_worker(JobRecord& record, Calls& calls) {
  if (const std::optional<WorkerEnd> end = executor_->poll(record.worker); end) {
    if (adopt_other_worker(record, *end)) return;
    settle(record, *end);
    return touch(record, calls);
  }
  bool frames_grew = false;
  if (refresh_progress(record, frames_grew)) return touch(record, calls);
  if (frames_grew) wake_watchers(record.job.id, calls);
}

// A server that was killed between starting a worker and hearing of it leaves one that its successor does not know.
bool JobStore::adopt_other_worker(JobRecord& record, const WorkerEnd& end) const {
  if (end.exit_code != kWorkerExitBusy) return false;
  const Result<WorkerInfo> other = read_worker(record.dir);
  if (!other || !worker_alive(*other)) return false;
  record.worker = *other;
  return true;
}

void JobStore::start_workers(Calls& calls) {
  int free_slots = options_.slots - count(JobState::running);
  for (auto& [id, record] : jobs_) {
    if (free_slots <= 0) return;
    if (record.job.state != JobState::queued) continue;
    Outcome<WorkerInfo> worker = executor_->start(record.dir, record.job.info);
    if (worker) {
      record.worker = *worker;
      record.job.state = JobState::running;
      record.job.start_time = utc_now();
      --free_slots;
    } else {
      settle_failed(record, {worker.error().reason, worker.error().message, {}});
    }
    touch(record, calls);
  }
}

void JobStore::touch(JobRecord& record, Calls& calls) {
  record.job.revision = ++revision_;
  wake_watchers(record.job.id, calls);
}

void JobStore::wake_watchers(const std::string& id, Calls& calls) const {
  for (const auto& [watch, watcher] : watchers_) {
    if (watcher.job == id) calls.push_back(watcher.changed);
  }
}

JobStore::WatchId JobStore::watch(const std::string& id, std::function<void()> changed) {
  const std::lock_guard lock(mutex_);
  watchers_[++last_watch_] = {id, std::move(changed)};
  return last_watch_;
}

void JobStore::unwatch(WatchId watch) {
  const std::lock_guard lock(mutex_);
  watchers_.erase(watch);
  if (watchers_.empty()) unwatched_.notify_all();
}

void JobStore::wait_unwatched(double seconds) {
  std::unique_lock lock(mutex_);
  unwatched_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return watchers_.empty(); });
}

bool JobStore::stopping() const {
  const std::lock_guard lock(mutex_);
  return stopping_;
}

void JobStore::stop() {
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return;
    stopping_ = true;
    for (const auto& [id, watcher] : watchers_) calls.push_back(watcher.changed);
  }
  work_.notify_all();
  thread_.join();
  for (const auto& call : calls) call();
}

void JobStore::stop_jobs(double grace_s) {
  std::unique_lock lock(mutex_);
  for (auto& [id, record] : jobs_) {
    if (record.job.state == JobState::running) cancel_locked(id);
  }
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(grace_s);
  Calls calls;  // nobody is left to be told
  for (poll_workers(calls); count(JobState::running) > 0; poll_workers(calls)) {
    if (std::chrono::steady_clock::now() > deadline) {
      for (auto& [id, record] : jobs_) {
        if (record.job.state == JobState::running) executor_->kill(record.worker);
      }
    }
    work_.wait_for(lock, kPollInterval);
  }
}

}  // namespace slipstitch::jobs
