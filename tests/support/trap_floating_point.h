// SPDX-License-Identifier: MIT
#pragma once

#include <fenv.h>

#include <stdexcept>

namespace slipstitch::testing {

/// While it lives, an invalid operation or a division by zero in this thread ends the program with SIGFPE. Threads that
/// start meanwhile inherit it. Overflow and underflow pass. x86 and glibc only.
class TrapFloatingPoint {
 public:
  TrapFloatingPoint() {
    feclearexcept(FE_ALL_EXCEPT);  // or one that is pending would fire
    before_ = feenableexcept(kTrapped);
    if (before_ == -1) throw std::runtime_error("floating-point traps: not available here");
  }
  ~TrapFloatingPoint() {
    feclearexcept(FE_ALL_EXCEPT);
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
  }
  TrapFloatingPoint(const TrapFloatingPoint&) = delete;
  TrapFloatingPoint& operator=(const TrapFloatingPoint&) = delete;

 private:
  static constexpr int kTrapped = FE_INVALID | FE_DIVBYZERO;
  int before_ = 0;
};

}  // namespace slipstitch::testing
