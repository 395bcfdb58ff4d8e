// SPDX-License-Identifier: MIT
#include "platform/memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace slipstitch {

// VmHWM and not getrusage: ru_maxrss survives exec, so a worker would report its parent's peak.
std::optional<long> peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  std::string key;
  while (status >> key) {
    long kibibytes = 0;
    if (key == "VmHWM:" && status >> kibibytes) return kibibytes * 1024;
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

}  // namespace slipstitch
