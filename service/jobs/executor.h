// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "jobs/error.h"
#include "run_dir/run_dir.h"

namespace slipstitch::jobs {

/// How a worker ended. Both are empty for one that an earlier server started: only its parent is told.
struct WorkerEnd {
  std::optional<int> exit_code;
  std::optional<int> signal;
};

/// Runs the worker of a job. The worker writes worker.json, the frames and, last, summary.json. Called by one thread.
class Executor {
 public:
  virtual ~Executor() = default;

  virtual Outcome<WorkerInfo> start(const RunDir& dir, const JobInfo& job) = 0;

  /// Empty while the worker runs, whether this executor started it or an earlier server did.
  virtual std::optional<WorkerEnd> poll(const WorkerInfo& worker) = 0;

  /// Ends the worker now.
  virtual void kill(const WorkerInfo& worker) = 0;
};

/// Exit code of a worker that found another one at work on its job.
inline constexpr int kWorkerExitBusy = 75;

}  // namespace slipstitch::jobs
