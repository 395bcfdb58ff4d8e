// SPDX-License-Identifier: MIT
#pragma once

#include "run_dir/run_recorder.h"

namespace slipstitch {

/// run_job() of a study: what it runs is kept in study/, so that a worker goes on where one before it was killed, and
/// the report goes to report/. Returns the parts of a RunSummary that a study has.
Result<RunSummary> run_study_job(const RunDir& dir, const JobInfo& job, const RecorderOptions& options);

}  // namespace slipstitch
