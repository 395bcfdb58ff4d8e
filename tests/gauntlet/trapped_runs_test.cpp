// SPDX-License-Identifier: MIT
// Whole runs, their linear solver included, without an invalid operation or a division by zero.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "gauntlet/gauntlet_case.h"
#include "support/trap_floating_point.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kDuration = 0.04;  // [s], with the hardest part of these cases

GauntletCase short_case(const std::string& name) {
  const std::vector<GauntletCase> cases = gauntlet_cases();
  GauntletCase found = *std::find_if(cases.begin(), cases.end(), [&](const auto& item) { return item.name == name; });
  found.scene.duration_s = std::min(found.scene.duration_s, kDuration);
  return found;
}

class TrappedRuns : public ::testing::TestWithParam<const char*> {};

TEST_P(TrappedRuns, DivideByNoZero) {
  const GauntletCase item = short_case(GetParam());
  for (const bool simplicial : {false, true}) {
    Settings settings;
    settings.simplicial = simplicial;
    const testing::TrapFloatingPoint trap;
    EXPECT_GT(run_cell(item, settings).summary.steps, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Gauntlet, TrappedRuns,
                         ::testing::Values("slide-into-neighbour", "snag", "crowded-yarn", "selvedge-corner",
                                           "stretched-300-released", "compressed-30", "noise-of-half-a-stitch",
                                           "folded-inside-out", "sharp-edge", "sphere-at-20-m/s", "mass-ratio-1e6",
                                           "friction-0-and-10", "stretch-times-1000", "sliding-friction-0"),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

}  // namespace
}  // namespace slipstitch::gauntlet
