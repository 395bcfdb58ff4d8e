// SPDX-License-Identifier: MIT
// An effect that a scene does not list costs nothing: shown by counting instructions, which no clock and no load sways.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "program_output.h"

namespace slipstitch::test {
namespace {

constexpr double kAllowed = 0.005;  // of the count

/// Counts what a program takes in its time steps, relaxation and start-up left out; returns callgrind's own words.
std::string count_steps(const std::string& program, const std::string& profile) {
  const std::string text = output_of(
      // kernels that callgrind can execute, and the same ones whatever the CPU
      "OPENBLAS_CORETYPE=Haswell OPENBLAS_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file=" + profile +
      " --toggle-collect='slipstitch::Simulation::step(*' " + in_bin(program) + " 0.0125 2>&1");
  EXPECT_NE(text.find("succeeded"), std::string::npos) << text;
  return text;
}

/// What of a profile the C library's allocator took. How far it searches depends on how the heap lies, which programs
/// of different size differ in, more than on what is asked of it.
long in_allocator(const std::string& profile) {
  const std::string sum = output_of("callgrind_annotate --tree=none --threshold=100 " + profile +
                                    " | awk '/malloc[.]c:/ { gsub(\",\", \"\", $1); sum += $1 } END { print sum }'");
  long count = 0;
  EXPECT_EQ(std::sscanf(sum.c_str(), "%ld", &count), 1) << sum;
  return count;
}

/// The allocator's own left out.
long steps_instructions(const std::string& program) {
  const std::string profile = ::testing::TempDir() + "slipstitch_" + program + ".out";
  const std::string text = count_steps(program, profile);
  const std::size_t at = text.find("Collected : ");
  long count = 0;
  EXPECT_TRUE(at != std::string::npos && std::sscanf(text.c_str() + at, "Collected : %ld", &count) == 1) << text;
  EXPECT_GT(count, 100'000'000) << "no steps were counted";
  const long allocator = in_allocator(profile);
  EXPECT_GT(allocator, 0);
  EXPECT_LT(allocator, count / 20);
  return count - allocator;
}

TEST(ZeroCost, TheTermsThatAreOffTakeNoInstructions) {
  const long all = steps_instructions("swatch_run_all_terms"), listed = steps_instructions("swatch_run_listed_terms");
  const double share = static_cast<double>(all - listed) / static_cast<double>(listed);
  std::printf("%ld instructions with all terms, %ld with those that are on: %+.3f %%\n", all, listed, 100.0 * share);
  EXPECT_LE(std::abs(share), kAllowed);
  EXPECT_EQ(steps_instructions("swatch_run_all_terms"), all) << "the count depends on more than the program";
  EXPECT_EQ(steps_instructions("swatch_run_listed_terms"), listed) << "the count depends on more than the program";
}

long allocations(const std::string& program) {
  std::string text =
      output_of("OPENBLAS_CORETYPE=Haswell OPENBLAS_NUM_THREADS=1 valgrind --leak-check=no --undef-value-errors=no " +
                in_bin(program) + " 0.0125 2>&1");
  std::erase(text, ',');
  const std::size_t at = text.find("total heap usage: ");
  long count = 0;
  EXPECT_TRUE(at != std::string::npos && std::sscanf(text.c_str() + at, "total heap usage: %ld", &count) == 1) << text;
  return count;
}

// What the count of instructions leaves out.
TEST(ZeroCost, TheTermsThatAreOffAllocateNothing) {
  const long all = allocations("swatch_run_all_terms"), listed = allocations("swatch_run_listed_terms");
  std::printf("%ld allocations with all terms, %ld with those that are on\n", all, listed);
  EXPECT_GT(listed, 1000);
  EXPECT_LE(static_cast<double>(all - listed), kAllowed * static_cast<double>(listed));
}

// Some effects act inside the terms of others, and have none that a list could leave out.
TEST(ZeroCost, NoFunctionOfAnEffectThatIsOffIsCalled) {
  const std::string profile = ::testing::TempDir() + "slipstitch_called.out";
  count_steps("swatch_run_all_terms", profile);
  const std::string called = output_of("grep -h '^c\\?fn=' " + profile);
  const std::string known = output_of("nm -C " + in_bin("swatch_run_all_terms"));
  EXPECT_NE(called.find("slipstitch::Stretch::eval("), std::string::npos) << "the profile names no functions";
  for (const char* off : {"set_bending_energy(", "convex_set_bending(", "crept_set(", "scale_arc_rows(",
                          "air_velocity(", "NearSegments::cover(", "RigidBody::distance(", "estimate_normal_forces("}) {
    EXPECT_NE(known.find(off), std::string::npos) << off << " is not the name of a function";
    EXPECT_EQ(called.find(off), std::string::npos) << off;
  }
}

}  // namespace
}  // namespace slipstitch::test
