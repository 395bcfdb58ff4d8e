// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "jobs/executor.h"
#include "jobs/job.h"

namespace slipstitch::jobs {

/// What a server reads of any summary.json.
struct ServerSummary {
  RunStatus status = RunStatus::failed;
  Failure failure;  // of a failed run
};

/// Empty: not a summary.
std::optional<ServerSummary> parse_summary(std::string_view text);

/// summary.json of a job whose worker could not write one: nothing measured, all of it null. `reason` and `log_tail`
/// are there besides the keys of a run's own summary.
std::string server_summary(RunStatus status, const std::string& scene_name, const Failure& failure);

/// Why a worker is gone that left no summary.
Failure failure_of(const WorkerEnd& end, const RunDir& dir);

/// At most 20 lines and 4 KiB from the end of a log.
std::vector<std::string> log_tail(const std::filesystem::path& file);

/// Time of last modification, RFC 3339, UTC; empty when there is no such file.
std::string file_time(const std::filesystem::path& file);

}  // namespace slipstitch::jobs
