// SPDX-License-Identifier: MIT
// The trap itself: it fires on what it is set for, on nothing else, and leaves no trace.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "support/trap_floating_point.h"

namespace slipstitch::testing {
namespace {

constexpr int kFired = 77;

// Sanitizers have a handler of their own.
void divide(double a, double b) {
  std::signal(SIGFPE, [](int) { std::_Exit(kFired); });
  const volatile double above = a, below = b;
  const volatile double ratio = above / below;
  (void)ratio;
}

TEST(ElementTrapDeathTest, FiresOnAnInvalidOperationAndOnADivisionByZero) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto trapped = [](double a, double b) {
    const TrapFloatingPoint trap;
    divide(a, b);
    std::_Exit(0);
  };
  EXPECT_EXIT(trapped(0.0, 0.0), ::testing::ExitedWithCode(kFired), "");
  EXPECT_EXIT(trapped(1.0, 0.0), ::testing::ExitedWithCode(kFired), "");
  EXPECT_EXIT(trapped(1e300, 1e-300), ::testing::ExitedWithCode(0), "");
}

TEST(ElementTrap, IsGoneAtTheEndOfItsScopeAndNests) {
  ASSERT_EQ(fegetexcept(), 0);
  {
    const TrapFloatingPoint trap;
    { const TrapFloatingPoint again; }
    EXPECT_EQ(fegetexcept(), FE_INVALID | FE_DIVBYZERO);
  }
  EXPECT_EQ(fegetexcept(), 0);
  const volatile double zero = 0.0;
  const volatile double ratio = zero / zero;
  EXPECT_NE(ratio, ratio);
}

}  // namespace
}  // namespace slipstitch::testing
