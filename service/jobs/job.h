// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "run_dir/run_json.h"

namespace slipstitch::jobs {

enum class JobState { queued, running, succeeded, failed, cancelled };

inline constexpr std::array kJobStates{JobState::queued, JobState::running, JobState::succeeded, JobState::failed,
                                       JobState::cancelled};
std::string_view state_name(JobState state);  // "queued"

inline bool is_terminal(JobState state) { return state != JobState::queued && state != JobState::running; }

/// Why a job FAILED.
struct Failure {
  std::string reason;  // SIMULATION_FAILED, WORKER_LOST, WORKER_CRASHED or STORAGE_FAILED
  std::string message;
  std::vector<std::string> log_tail;  // last lines of the worker's log; empty when the run itself said why
};

/// One consistent view of a job.
struct Job {
  std::string id;
  JobInfo info;
  JobState state = JobState::queued;
  bool cancel_requested = false;
  std::uint64_t revision = 0;        // grows with every change, also over restarts of the server
  std::string start_time, end_time;  // RFC 3339, UTC; empty: not yet
  std::optional<ProgressInfo> progress;
  std::optional<Failure> failure;  // exactly when failed
  std::string summary_json;        // exactly when terminal
};

}  // namespace slipstitch::jobs
