// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kGravity = 9.81, kDensity = 1e-3;

/// A free yarn, straight and across its fall, in five pieces of unequal length.
Scene falling(const AirDragEffect& drag) {
  Scene scene;
  BareYarn yarn;
  for (const double x : {0.0, 0.01, 0.03, 0.08, 0.09, 0.2}) yarn.points.push_back({x, 0.0, 0.0});
  scene.yarns = {yarn};
  scene.yarn.linear_density_kg_per_m = kDensity;
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.air_drag = drag;
  return scene;
}

/// Speed of the fall after `end`; every point must have the same.
double speed_after(const AirDragEffect& drag, double end, int steps) {
  Simulation sim(checked_model(falling(drag)));
  advance(sim, steps, end / steps, tight(1e-10, 0.0));
  const double v = -sim.state().v[1];
  for (int n = 0; n < 6; ++n)
    EXPECT_LT((sim.state().v.segment<3>(3 * n) - Vec3(0.0, -v, 0.0)).norm(), 1e-8) << "point " << n;
  return v;
}

TEST(AirDrag, LinearDragEndsAtItsTerminalVelocity) {
  constexpr double kDrag = 5e-3, kTerminal = kDensity * kGravity / kDrag;
  EXPECT_NEAR(speed_after({kDrag, 0.0}, 3.0, 300) / kTerminal, 1.0, 1e-3);
}

TEST(AirDrag, QuadraticDragEndsAtItsTerminalVelocity) {
  constexpr double kDrag = 2e-3;
  const double terminal = std::sqrt(kDensity * kGravity / kDrag);
  EXPECT_NEAR(speed_after({0.0, kDrag}, 3.0, 300) / terminal, 1.0, 1e-3);
}

TEST(AirDrag, DefaultsToThatOfACylinderInAir) {
  const double per_metre = 0.5 * 1.2 * 1.2 * 2.0 * YarnMaterial().radius_m;
  const double terminal = std::sqrt(kDensity * kGravity / per_metre);
  EXPECT_NEAR(speed_after({}, 6.0, 300) / terminal, 1.0, 1e-3);
}

// v = v_t tanh(g t/v_t) on the way there.
TEST(AirDrag, ApproachesQuadraticallyWithFirstOrderInTime) {
  constexpr double kDrag = 2e-3, kEnd = 0.2;
  const AirDragEffect drag{0.0, kDrag};
  const double terminal = std::sqrt(kDensity * kGravity / kDrag);
  const double exact = terminal * std::tanh(kGravity * kEnd / terminal);
  const double coarse = speed_after(drag, kEnd, 50), middle = speed_after(drag, kEnd, 100),
               fine = speed_after(drag, kEnd, 200);
  EXPECT_GT(std::abs(coarse - exact), 1e-4);  // there is an error to measure
  EXPECT_NEAR(order(coarse - exact, middle - exact), 1.0, 0.05);
  EXPECT_NEAR(order(middle - exact, fine - exact), 1.0, 0.03);
  EXPECT_NEAR(extrapolated(coarse, middle, fine) / exact, 1.0, 1e-6);
}

}  // namespace
}  // namespace slipstitch::testing
