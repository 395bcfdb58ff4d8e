// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "jobs/in_process_executor.h"
#include "jobs/job_store.h"
#include "support/sample_run.h"

namespace slipstitch::jobs {

/// Work that does what a test tells it, instead of simulating: runs until let go or cancelled, then succeeds.
class HeldWork {
 public:
  void operator()(const RunDir& dir, const JobInfo& job) {
    RunSummary summary;
    summary.scene = job.scene_name;
    summary.status = wait(dir) ? RunStatus::succeeded : RunStatus::cancelled;
    EXPECT_EQ(write_summary(dir, summary), "");
  }

  void let_go() {
    const std::lock_guard lock(mutex_);
    free_ = true;
    changed_.notify_all();
  }

 private:
  bool wait(const RunDir& dir) {
    std::unique_lock lock(mutex_);
    while (!free_) {
      if (std::filesystem::exists(dir.control())) return false;
      changed_.wait_for(lock, std::chrono::milliseconds(2));
    }
    return true;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool free_ = false;
};

inline NewJob new_job(const std::string& request_id, const std::string& scene = "{\"name\":\"a\"}", int threads = 0) {
  NewJob job;
  job.request_id = request_id;
  job.scene_name = "a";
  job.scene_json = scene;
  job.threads = threads;
  job.spec_hash = [scene](int n) { return scene + "/" + std::to_string(n); };
  return job;
}

inline std::unique_ptr<JobStore> open_store(const std::filesystem::path& path, std::unique_ptr<Executor> executor,
                                            StoreOptions options = {}) {
  Outcome<DataDir> data = DataDir::open(path);
  if (!data) {
    ADD_FAILURE() << data.error().message;
    return nullptr;
  }
  std::vector<std::string> warnings;
  auto store = std::make_unique<JobStore>(std::move(*data), std::move(options), std::move(executor), warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  return store;
}

/// Lets the work go, because a store waits for threads that it started.
struct LetGo {
  HeldWork* work = nullptr;
  void operator()(JobStore* store) const {
    store->stop();
    work->let_go();
    delete store;
  }
};

inline std::unique_ptr<JobStore, LetGo> open_store(const std::filesystem::path& path, HeldWork& work,
                                                   StoreOptions options = {}) {
  return {open_store(path, make_in_process_executor(std::ref(work)), std::move(options)).release(), LetGo{&work}};
}

/// Returns the first snapshot that fits; the test's own time limit ends an endless wait.
inline Job wait_until(JobStore& store, const std::string& id, const std::function<bool(const Job&)>& fits) {
  for (;;) {
    const Outcome<Job> job = store.get(id);
    if (!job) {
      ADD_FAILURE() << job.error().message;
      return {};
    }
    if (fits(*job)) return *job;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

inline Job wait_for_end(JobStore& store, const std::string& id) {
  return wait_until(store, id, [](const Job& job) { return is_terminal(job.state); });
}

inline Job wait_for_state(JobStore& store, const std::string& id, JobState state) {
  return wait_until(store, id, [state](const Job& job) { return job.state == state; });
}

}  // namespace slipstitch::jobs
