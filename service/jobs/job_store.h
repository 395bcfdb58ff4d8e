// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "jobs/data_dir.h"
#include "jobs/job_id.h"
#include "jobs/job_record.h"

namespace slipstitch::jobs {

struct StoreOptions {
  int slots = 1;            // workers at a time, >= 1
  int queue = 100;          // jobs that wait beyond those, >= 0
  int default_threads = 1;  // of jobs that name none, >= 1
  std::string blas;         // core recorded in new jobs
};

struct NewJob {
  std::string request_id;  // empty: none
  std::string scene_name;
  std::string scene_json;                             // checked, every default written out
  int threads = 0;                                    // 0: default_threads
  std::optional<StudyWork> study;                     // absent: simulate
  std::function<std::string(int threads)> spec_hash;  // of the whole spec with so many threads
};

/// Problems of a request besides its scene.
Issues check_fields(const std::string& request_id, std::int64_t threads);

struct ListQuery {
  int page_size = 0;              // 0: 50, above 100: 100
  std::string page_token;         // empty: first page
  std::optional<JobState> state;  // only these
};

struct JobPage {
  std::vector<Job> jobs;        // newest first
  std::string next_page_token;  // empty: that was the end
};

/// Continues the list of `query` behind a job of it.
std::string page_token_after(const std::string& id, const ListQuery& query);

/// All jobs of a data directory, and the thread that runs them. Every method may be called from any thread; results are
/// copies. Errors are those of proto/slipstitch/v1/job.proto.
class JobStore {
 public:
  /// Takes over what an earlier server left in `data`: see load_job(). Folders that hold no job go to `warnings`.
  JobStore(DataDir data, StoreOptions options, std::unique_ptr<Executor> executor, std::vector<std::string>& warnings);
  ~JobStore();

  Outcome<Job> create(const NewJob& request);
  /// Checks what create() would of the request itself; the answer has no name and no state of a stored job.
  Outcome<Job> validate(const NewJob& request) const;
  Outcome<Job> get(const std::string& id) const;
  Outcome<JobPage> list(const ListQuery& query) const;
  Outcome<Job> cancel(const std::string& id);
  Outcome<Done> remove(const std::string& id);
  std::map<JobState, int> counts() const;  // of jobs in every state, 0 included
  Outcome<RunDir> folder(const std::string& id) const;

  /// Calls `changed` after every change of the job or its frames, from the scheduler's thread or that of a caller,
  /// never with a lock held. It may still come once while unwatch() returns.
  using WatchId = std::uint64_t;
  WatchId watch(const std::string& id, std::function<void()> changed);
  void unwatch(WatchId watch);

  /// No new jobs and no new workers from now on; watchers are woken. Workers run on.
  void stop();
  bool stopping() const;
  /// Waits until nobody watches, at most `seconds`.
  void wait_unwatched(double seconds);
  /// After stop(): asks all running jobs to end, waits `grace_s`, then kills what is left. Queued jobs stay queued.
  void stop_jobs(double grace_s);

 private:
  struct Watcher {
    std::string job;
    std::function<void()> changed;
  };
  using Calls = std::vector<std::function<void()>>;

  void recover(std::vector<std::string>& warnings);
  JobInfo info_of(const NewJob& request) const;
  Outcome<Job> create_locked(const NewJob& request);
  Outcome<Job> repeat_of(const JobRecord& existing, const NewJob& request) const;
  Outcome<Job> cancel_locked(const std::string& id);
  int count(JobState state) const;

  void schedule();  // body of thread_
  void poll_workers(Calls& calls);
  void poll_worker(JobRecord& record, Calls& calls);
  bool adopt_other_worker(JobRecord& record, const WorkerEnd& end) const;
  void start_workers(Calls& calls);
  void touch(JobRecord& record, Calls& calls);  // a new revision
  void wake_watchers(const std::string& id, Calls& calls) const;

  const DataDir data_;
  const StoreOptions options_;
  const std::unique_ptr<Executor> executor_;  // used by the scheduler's thread, and after it ended by stop_jobs()

  mutable std::mutex mutex_;  // guards all below
  std::condition_variable work_, unwatched_;
  std::map<std::string, JobRecord> jobs_;             // by id, so by time
  std::map<std::string, std::string> by_request_id_;  // -> id
  std::map<WatchId, Watcher> watchers_;
  WatchId last_watch_ = 0;
  std::uint64_t revision_ = 0;
  JobIdMaker ids_;
  bool new_work_ = false;  // a job for the scheduler to look at
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace slipstitch::jobs
