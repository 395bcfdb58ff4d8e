// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "run_dir/result.h"
#include "run_dir/worker_info.h"
#include "sim/run.h"

namespace slipstitch {

/// Study of proto/slipstitch/v1/job.proto.
struct StudyWork {
  bool quick = false;
  double budget_s = 0.0;  // 0: no end
  bool operator==(const StudyWork&) const = default;
};

/// job.json: what was decided when the job was created.
struct JobInfo {
  std::string name;        // simJobs/{id}; empty for a local run
  std::string request_id;  // empty: none given
  std::string spec_hash;
  int threads = 1;                                // >= 1, resolved
  std::string blas;                               // BLAS core
  std::string create_time;                        // RFC 3339, UTC, microseconds: sorts as text
  std::string scene_name;                         // Scene.name, so that a list of jobs needs no scene file
  std::optional<StudyWork> study = std::nullopt;  // absent: the scene is simulated
};

/// progress.json.
struct ProgressInfo {
  Progress progress;
  std::optional<double> eta_s;  // wall time to go: of a budget, else from the share done; absent before any is
  std::string update_time;      // RFC 3339, UTC
  double share_done = 0.0;      // 0 to 1
  std::string doing = {};       // for people
};

/// Of a simulation, now. "simulating" where it is that.
ProgressInfo progress_info(const Progress& progress);

/// summary.json of a study.
struct StudySummary {
  RunStatus status = RunStatus::failed;
  std::string message, scene;
  double wall_s = 0.0;
  std::optional<long> peak_memory_bytes;
  std::string blas, version;
  int threads = 1;
  nlohmann::ordered_json study;  // its results; null: none
};

/// Keys are the field names. Not measured, and not finite, is null, never 0.
nlohmann::ordered_json to_json(const JobInfo& job);
nlohmann::ordered_json to_json(const ProgressInfo& progress);
nlohmann::ordered_json to_json(const WorkerInfo& worker);
nlohmann::ordered_json to_json(const RunSummary& summary);
nlohmann::ordered_json to_json(const StudySummary& summary);  // all keys of a RunSummary, and "study"
nlohmann::ordered_json empty_summary();                       // all keys of a RunSummary, each null

/// Strict about types, lenient about unknown keys (a newer program may have written them).
Result<JobInfo> job_from_json(std::string_view text);
Result<ProgressInfo> progress_from_json(std::string_view text);
Result<WorkerInfo> worker_from_json(std::string_view text);
Result<RunSummary> summary_from_json(std::string_view text);

std::string_view status_word(RunStatus status);  // succeeded, failed, cancelled
std::optional<RunStatus> status_from_word(std::string_view word);

std::string utc_now();  // RFC 3339 with microseconds
double share_done(const Progress& progress);
std::optional<double> estimate_eta(const Progress& progress);

}  // namespace slipstitch
