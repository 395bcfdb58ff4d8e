// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "force/sliding_friction.h"
#include "sample_models.h"

namespace slipstitch::testing {
namespace {

// The spring holds at most mu F_n: an anchor stays while yarn sticks and trails by that reach once it slips.
TEST(FrictionAnchor, StaysWhileYarnSticksAndTrailsByItsReachOnceItSlips) {
  const Model model = everything_on();
  const SlidingFrictionEffect& effect = *model.effects.sliding_friction;
  const double reach = effect.coefficient * *effect.normal_force_n / effect.stick_stiffness_n_per_m;
  std::mt19937_64 random(7);
  const State start = state_at(model, model.start_q, random);
  SlidingFriction friction(model);
  friction.begin_step(StepContext{1e-3, start});
  ASSERT_GT(friction.size(), 0);
  for (double way : {0.5 * reach, -0.9 * reach, 3.0 * reach, -20.0 * reach}) {
    VecX q = start.q, anchor = start.anchor;
    q.tail(model.topology.num_visits()).array() += way;
    friction.drag_anchors(q, anchor);
    for (int k = 0; k < friction.size(); ++k) {
      const int arc = friction.coords(k)[0], visit = arc - model.topology.arc_coord(0);
      const double trail = std::abs(way) > reach ? std::copysign(reach, way) : way;
      EXPECT_NEAR(q[arc] - anchor[visit], trail, 1e-15);
    }
  }
}

}  // namespace
}  // namespace slipstitch::testing
