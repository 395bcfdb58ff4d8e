// SPDX-License-Identifier: MIT
#include "run_dir/worker_info.h"

#include <fstream>
#include <sstream>

namespace slipstitch {

std::optional<std::uint64_t> process_start_ticks(std::int64_t pid) {
  if (pid <= 0) return std::nullopt;
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::ostringstream read;
  read << file.rdbuf();  // a process that ends meanwhile is a read error, which iterators of the buffer throw
  const std::string text = read.str();
  // Field 2, the program's name in parentheses, may hold anything: count from behind its end (proc(5)).
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(text.substr(name_end + 1));
  std::string state;
  fields >> state;
  if (state == "Z" || state == "X") return std::nullopt;
  std::string skipped;
  for (int field = 4; field < 22; ++field) fields >> skipped;
  std::uint64_t ticks = 0;
  if (!(fields >> ticks)) return std::nullopt;
  return ticks;
}

std::string current_boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  file >> id;
  return id;
}

std::optional<WorkerInfo> describe_process(std::int64_t pid) {
  const auto ticks = process_start_ticks(pid);
  if (!ticks) return std::nullopt;
  return WorkerInfo{pid, *ticks, current_boot_id(), "local:" + std::to_string(pid)};
}

bool worker_alive(const WorkerInfo& worker) {
  return worker.boot_id == current_boot_id() && process_start_ticks(worker.pid) == worker.start_ticks;
}

}  // namespace slipstitch
