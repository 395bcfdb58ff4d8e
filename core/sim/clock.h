// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>

namespace slipstitch {

/// Seconds from any start on, never falling.
using Clock = std::function<double()>;

inline double steady_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace slipstitch
