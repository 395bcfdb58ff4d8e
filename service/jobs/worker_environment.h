// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "run_dir/run_json.h"

namespace slipstitch::jobs {

/// The BLAS core that new jobs run with: OPENBLAS_CORETYPE where the user set it, else the best one for this CPU.
std::string blas_core_for_jobs();

/// Threads of a job that names none: the cores of this machine shared by `slots` workers, at least 1.
int default_threads(int slots);

/// NAME=VALUE of the environment of a job's worker: that of this process, with the BLAS core and threads of the job.
std::vector<std::string> worker_environment(const JobInfo& job);

}  // namespace slipstitch::jobs
