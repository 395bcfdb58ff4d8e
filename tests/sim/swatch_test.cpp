// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

double total(const std::map<std::string, double>& energies) {
  return std::accumulate(energies.begin(), energies.end(), 0.0,
                         [](double sum, const auto& e) { return sum + e.second; });
}

TEST(Swatch, LosesEnergyWhileItComesToRest) {
  Prepared prepared = prepare(free_swatch(4, 4));
  ASSERT_FALSE(prepared.failure) << *prepared.failure;
  Simulation sim(std::move(prepared.model));
  const double start = total(sim.energies());
  double before = start;
  double h = 1.0 / 240;
  while (sim.state().t < 0.05) {
    if (!sim.step(h, FixedNumerics{}, {}).accepted) {
      h *= 0.5;
      ASSERT_GT(h, 1e-5);
      continue;
    }
    const double now = total(sim.energies());
    EXPECT_LE(now, before + 1e-6 * start) << sim.state().t;
    before = now;
    h = std::min(2.0 * h, 1.0 / 240);
  }
  EXPECT_LT(before, 0.98 * start);
}

TEST(Swatch, RunsTwiceToTheSameBits) {
  std::vector<VecX> frames[2];
  RunSummary summary[2];
  for (std::size_t k = 0; k < 2; ++k) {
    RunHooks hooks;
    hooks.on_frame = [&](const Frame& frame) { frames[k].push_back(frame.q); };
    summary[k] = run(free_swatch(4, 4), 1, hooks);
    ASSERT_EQ(summary[k].status, RunStatus::succeeded) << summary[k].message;
  }
  EXPECT_EQ(summary[0].state_hash, summary[1].state_hash);
  EXPECT_EQ(summary[0].newton_iterations, summary[1].newton_iterations);
  ASSERT_EQ(frames[0].size(), frames[1].size());
  for (std::size_t i = 0; i < frames[0].size(); ++i) EXPECT_EQ(frames[0][i], frames[1][i]) << i;
  EXPECT_NE(frames[0].front(), frames[0].back());
  // and reports what a knit reports
  EXPECT_EQ(summary[0].loops, 16);
  EXPECT_EQ(summary[0].effects.size(), 10U);
  EXPECT_TRUE(summary[0].faded_wrap_share.has_value());
  EXPECT_TRUE(summary[0].wrap_ridge_entries.has_value());
  EXPECT_TRUE(summary[0].max_slid_m.has_value());
  EXPECT_GT(summary[0].min_arc_gap_ratio.value_or(0.0), 0.0);
}

}  // namespace
}  // namespace slipstitch::testing
