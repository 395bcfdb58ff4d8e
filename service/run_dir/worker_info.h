// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace slipstitch {

/// Which process runs a job. Pids are reused, start times are not within one boot of one machine.
struct WorkerInfo {
  std::int64_t pid = 0;
  std::uint64_t start_ticks = 0;  // clock ticks after boot, field 22 of /proc/PID/stat
  std::string boot_id;            // /proc/sys/kernel/random/boot_id
  std::string handle;             // of the executor, e.g. "local:1234"
};

/// Empty when there is no such process, or only its unreaped remains.
std::optional<std::uint64_t> process_start_ticks(std::int64_t pid);

std::string current_boot_id();

/// Of a live process (`pid`), with handle "local:PID".
std::optional<WorkerInfo> describe_process(std::int64_t pid);

/// The same process, still running on this machine.
bool worker_alive(const WorkerInfo& worker);

}  // namespace slipstitch
