// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sim/run.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch {

/// A job's own fields, `status` in the words of summary.json; once it has ended all of summary.json beside them.
nlohmann::ordered_json job_json(const v1::SimJob& job);

/// A few lines for people; the summary is not part of them.
std::string job_text(const v1::SimJob& job);

/// Prints the summary of an ended job, nothing where there is none.
std::string job_summary_text(const v1::SimJob& job);

std::string state_text(const v1::SimJob& job);     // "RUNNING, cancel requested"
std::string work_text(const v1::SimJob& job);      // "simulate", "quick study, at most 60 s"
std::string progress_text(const v1::SimJob& job);  // "47 %"; empty: none
std::string create_time_text(const v1::SimJob& job);

/// False: it is a study, or still chooses effects, as `doing` says.
bool is_simulating(const v1::JobProgress& progress);
Progress progress_from(const v1::JobProgress& message);
std::optional<double> eta_from(const v1::SimJob& job);

/// Of a job that ended: 0, 1 or 4.
int exit_code_of(v1::SimJob::State state);

}  // namespace slipstitch
