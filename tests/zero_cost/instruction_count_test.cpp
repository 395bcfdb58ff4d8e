// SPDX-License-Identifier: MIT
// An effect that a scene does not list costs nothing: shown by counting instructions, which no clock and no load sways.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "program_output.h"

namespace slipstitch::test {
namespace {

constexpr double kAllowed = 0.005;  // of the count

/// Instructions that a program takes in its time steps, relaxation and start-up left out.
long steps_instructions(const std::string& program) {
  const std::string text = output_of(
      // kernels that callgrind can execute, and the same ones whatever the CPU
      "OPENBLAS_CORETYPE=Haswell OPENBLAS_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null "
      "--toggle-collect='slipstitch::Simulation::step(*' " +
      in_bin(program) + " 0.0125 2>&1");
  EXPECT_NE(text.find("succeeded"), std::string::npos) << text;
  const std::size_t at = text.find("Collected : ");
  long count = 0;
  EXPECT_TRUE(at != std::string::npos && std::sscanf(text.c_str() + at, "Collected : %ld", &count) == 1) << text;
  EXPECT_GT(count, 100'000'000) << "no steps were counted";
  return count;
}

TEST(ZeroCost, TheTermsThatAreOffTakeNoInstructions) {
  const long all = steps_instructions("swatch_run_all_terms"), listed = steps_instructions("swatch_run_listed_terms");
  const double share = static_cast<double>(all - listed) / static_cast<double>(listed);
  std::printf("%ld instructions with all terms, %ld with those that are on: %+.3f %%\n", all, listed, 100.0 * share);
  EXPECT_LE(std::abs(share), kAllowed);
  EXPECT_EQ(steps_instructions("swatch_run_all_terms"), all) << "the count depends on more than the program";
  EXPECT_EQ(steps_instructions("swatch_run_listed_terms"), listed) << "the count depends on more than the program";
}

}  // namespace
}  // namespace slipstitch::test
