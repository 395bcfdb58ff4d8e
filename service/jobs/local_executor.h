// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "jobs/executor.h"

namespace slipstitch::jobs {

/// One `slipstitch-worker --job-dir DIR` a job, in a session of its own, so that it outlives the server. Its stdout and
/// stderr go to DIR/worker.log. `program` must be executable.
Outcome<std::unique_ptr<Executor>> make_local_executor(const std::filesystem::path& program);

inline std::filesystem::path worker_log(const RunDir& dir) { return dir.path / "worker.log"; }

}  // namespace slipstitch::jobs
