// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <thread>

#include "cli/remote/read_stream.h"

namespace slipstitch {

/// Waits between attempts to open a stream again: 0.25 s, doubling to 4 s, six times; from the start after progress.
class RetryPause {
 public:
  void progress() { attempts_ = 0; }

  /// False: no attempt is left, or the user wants to stop.
  bool wait(const StopTest& should_stop) {
    constexpr int kAttempts = 6;
    if (attempts_ == kAttempts) return false;
    const auto pause = std::min(std::chrono::milliseconds(4000), std::chrono::milliseconds(250 << attempts_));
    ++attempts_;
    const auto end = std::chrono::steady_clock::now() + pause;
    while (std::chrono::steady_clock::now() < end) {
      if (should_stop()) return false;
      std::this_thread::sleep_for(kStopTestInterval);
    }
    return !should_stop();
  }

 private:
  int attempts_ = 0;
};

}  // namespace slipstitch
