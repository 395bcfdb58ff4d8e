// SPDX-License-Identifier: MIT
#pragma once

#include "run_dir/run_recorder.h"

namespace slipstitch {

/// Does the work that stands in a run directory, with the threads of its job.json and nothing else of this machine, and
/// writes the results beside it; summary.json last. A scene that cannot be read or run is a failed run, not an error.
/// Error: the directory holds no job, or its summary could not be written. The recorder polls control.log every Newton
/// iteration, whatever `options` say; that of a study, whose runs are timed, as often as they say.
Result<RunSummary> run_job(const RunDir& dir, RecorderOptions options = {});

}  // namespace slipstitch
