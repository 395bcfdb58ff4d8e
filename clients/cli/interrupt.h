// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace slipstitch {

/// Ctrl-C (SIGINT) and SIGTERM as something to ask for: the first waits until requested() sees it, the second ends the
/// process at once. Make it on the main thread before other threads start; ask on the main thread.
class Interrupt {
 public:
  explicit Interrupt(std::function<void()> on_first);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested();

 private:
  std::function<void()> on_first_;
  bool requested_ = false;
};

}  // namespace slipstitch
