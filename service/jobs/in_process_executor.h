// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "jobs/executor.h"

namespace slipstitch::jobs {

/// Runs `work` on a thread of this process, as the worker program does in a process: it reads the job from the
/// directory and writes summary.json last. For tests: a crash of the work takes the server with it, kill() only waits.
std::unique_ptr<Executor> make_in_process_executor(std::function<void(const RunDir&, const JobInfo&)> work);

}  // namespace slipstitch::jobs
