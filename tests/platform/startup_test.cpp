// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "platform/blas.h"
#include "platform/memory.h"
#include "platform/version.h"

namespace slipstitch {
namespace {

struct ProbeResult {
  std::vector<std::string> pids;              // one entry per start of the program
  std::map<std::string, std::string> values;  // key -> rest of the line
};

/// Runs the probe with `environment` ("NAME=value ...").
ProbeResult run_probe(const std::string& environment, const std::string& arguments = "") {
  const std::string command = "exec env -u OPENBLAS_CORETYPE -u OPENBLAS_NUM_THREADS " + environment + " " +
                              SLIPSTITCH_BIN_DIR "/startup_probe " + arguments;
  std::string output;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 512> buffer{};
  while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) output += buffer.data();
  EXPECT_EQ(pipe == nullptr ? -1 : pclose(pipe), 0) << command << '\n' << output;

  ProbeResult result;
  std::istringstream lines(output);
  for (std::string key, rest; lines >> key && std::getline(lines >> std::ws, rest);) {
    if (key == "start") {
      result.pids.push_back(rest);
    } else {
      result.values[key] = rest;
    }
  }
  return result;
}

/// Instruction sets of the first CPU, as the kernel lists them.
std::set<std::string> cpu_flags() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::string line;
  while (std::getline(cpuinfo, line) && !line.starts_with("flags")) {
  }
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

TEST(Startup, BestCoreAgreesWithTheKernelsCpuFlags) {
  const std::set<std::string> flags = cpu_flags();
  const std::vector<std::string> skylake = {"avx512f", "avx512dq", "avx512bw", "avx512vl", "avx512cd"};
  const bool avx512 = std::ranges::all_of(skylake, [&](const auto& flag) { return flags.contains(flag); });
  EXPECT_EQ(best_blas_core(), avx512 ? "SkylakeX" : "Haswell");  // the tests themselves need AVX2 and FMA
}

TEST(Startup, ChoosesKernelsThatFitTheCpu) {
  ProbeResult probe = run_probe("");
  ASSERT_TRUE(best_blas_core().has_value());
  EXPECT_EQ(probe.values["coretype"], *best_blas_core());
  EXPECT_EQ(probe.values["kernel"], *best_blas_core());
  EXPECT_EQ(probe.values["num_threads"], "3");
}

TEST(Startup, StartsAgainOnceWithTheSamePidAndArguments) {
  ProbeResult probe = run_probe("", "one 'two words'");
  ASSERT_EQ(probe.pids.size(), 2u);
  EXPECT_EQ(probe.pids[0], probe.pids[1]);
  EXPECT_EQ(probe.values["arguments"], "2 one two words");
}

TEST(Startup, KeepsWhatTheUserSet) {
  ProbeResult core = run_probe("OPENBLAS_CORETYPE=Prescott");
  EXPECT_EQ(core.values["coretype"], "Prescott");
  EXPECT_EQ(core.values["kernel"], "Prescott");
  EXPECT_EQ(core.values["num_threads"], "3");
  ProbeResult threads = run_probe("OPENBLAS_NUM_THREADS=1");
  EXPECT_EQ(threads.values["num_threads"], "1");
  EXPECT_EQ(threads.values["coretype"], best_blas_core().value_or("unset"));
}

TEST(Startup, DoesNotStartAgainWhenNothingIsMissing) {
  EXPECT_EQ(run_probe("OPENBLAS_CORETYPE=Haswell OPENBLAS_NUM_THREADS=2").pids.size(), 1u);
  EXPECT_EQ(run_probe("OPENBLAS_CORETYPE= OPENBLAS_NUM_THREADS=").pids.size(), 1u);
}

TEST(Startup, BlasThreadsCanChangeLater) { EXPECT_EQ(run_probe("").values["threads_set_to_one"], "1"); }

TEST(Memory, PeakGrowsWithUse) {
  const long before = peak_memory_bytes().value();
  const std::vector<char> block(64 << 20, 1);
  EXPECT_GE(peak_memory_bytes().value(), before + (48 << 20)) << block.size();
}

TEST(Memory, PeakIsOfThisProgramAndNotOfItsParent) {
  const std::vector<char> block(256 << 20, 1);
  EXPECT_LT(std::stol(run_probe("").values["peak"]), 128 << 20) << block.size();
}

TEST(Version, LineNamesProgramVersionAndBlas) {
  EXPECT_EQ(version_line("slipstitchd"), "slipstitchd " + version_string() + " (" + to_string(blas_in_use()) + ")");
  EXPECT_EQ(to_string({"SkylakeX", 2}), "OpenBLAS SkylakeX, 2 threads");
  EXPECT_EQ(to_string({"Haswell", 1}), "OpenBLAS Haswell, 1 thread");
  EXPECT_EQ(to_string({}), "unknown BLAS");
}

}  // namespace
}  // namespace slipstitch
