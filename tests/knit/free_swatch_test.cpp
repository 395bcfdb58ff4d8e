// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>

#include "swatch.h"

namespace slipstitch {
namespace {

// Nothing holds the yarn but its own stiffness: no pins, no friction. A run stops by itself where a contact comes
// within a radius of a yarn end.
TEST(FreeSwatch, WithoutFrictionKeepsEveryContactForTenSeconds) {
  Scene scene;
  scene.name = "free swatch";
  scene.knit.emplace();
  scene.knit->pattern = test::pattern_of({"stockinette", 5, 5, 1, 1, {}});
  scene.knit->gauge = {2.9e-3, 2.03e-3, {}};
  scene.knit->noise_m = 1e-6;
  scene.effects = test::knit_effects();
  scene.effects.inertia.emplace();
  scene.effects.sliding.emplace();
  scene.effects.contact_length.emplace();
  scene.effects.parallel_contact.emplace();
  scene.effects.damping.emplace();
  scene.duration_s = 10.0;
  scene.frames_per_s = 1.0;
  scene.numerics = FixedNumerics{};
  ASSERT_TRUE(check(scene).empty());
  const RunSummary summary = run(scene, 1, {});
  std::printf("%ld steps, %ld rejected; smallest segment %.3f of its rest length, slid %.3f mm\n", summary.steps,
              summary.rejected_steps, summary.min_arc_gap_ratio.value_or(-1.0),
              1e3 * summary.max_slid_m.value_or(-1.0));
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  EXPECT_DOUBLE_EQ(summary.sim_time_s, 10.0);
  ASSERT_TRUE(summary.min_arc_gap_ratio.has_value());
  EXPECT_GT(*summary.min_arc_gap_ratio, 0.0);
}

}  // namespace
}  // namespace slipstitch
