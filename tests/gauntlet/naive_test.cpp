// SPDX-License-Identifier: MIT
// Every naive variant is another computation, in a case that asks for what it leaves out.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "gauntlet/gauntlet_cells.h"

namespace slipstitch::gauntlet {
namespace {

GauntletCase short_case(const std::string& name) {
  const std::vector<GauntletCase> cases = gauntlet_cases();
  GauntletCase found = *std::find_if(cases.begin(), cases.end(), [&](const auto& item) { return item.name == name; });
  found.scene.duration_s = 0.009;
  found.limits.max_newton = 300;  // for those that get nowhere
  return found;
}

std::string outcome_of(const GauntletCase& item, const Settings& settings) {
  const RunSummary summary = run_cell(item, settings).summary;
  return summary.state_hash + std::to_string(summary.newton_iterations);
}

TEST(Naive, EveryVariantTakesAnotherWay) {
  const GauntletCase wild = short_case("noise-of-half-a-stitch"), pulled = short_case("selvedge-corner");
  const std::string wild_outcome = outcome_of(wild, {}), pulled_outcome = outcome_of(pulled, {});
  for (const NaiveVariant& variant : naive_variants()) {
    Settings naive;
    make_naive(variant, naive);
    EXPECT_TRUE(outcome_of(wild, naive) != wild_outcome || outcome_of(pulled, naive) != pulled_outcome) << variant.name;
  }
  EXPECT_EQ(outcome_of(wild, {}), wild_outcome);
}

}  // namespace
}  // namespace slipstitch::gauntlet
