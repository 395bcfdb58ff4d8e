// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "run_dir/run_json.h"

namespace slipstitch::jobs {

/// The BLAS core that new jobs run with: OPENBLAS_CORETYPE where the user set it, else the best one for this CPU.
std::string blas_core_for_jobs();

/// Threads of a job that names none. Only BLAS uses more, and the dense blocks of a knit's factor are too small for it:
/// two threads spend more time meeting than computing, ten times more on a busy machine.
inline constexpr int kDefaultThreads = 1;

/// NAME=VALUE of the environment of a job's worker: that of this process, with the BLAS core and threads of the job.
std::vector<std::string> worker_environment(const JobInfo& job);

}  // namespace slipstitch::jobs
