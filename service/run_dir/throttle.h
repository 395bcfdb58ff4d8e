// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

namespace slipstitch {

/// True at the first call and then at most once per interval.
class Throttle {
 public:
  explicit Throttle(double interval_s) : interval_(interval_s) {}
  bool due() {
    const Clock::time_point now = Clock::now();
    if (last_ && now - *last_ < interval_) return false;
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double> interval_;
  std::optional<Clock::time_point> last_;
};

}  // namespace slipstitch
