// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kGravity = 9.81;

// Yarn of rest length 1.1 between two points 1 apart on one level; k_s = kap * weight. Sag of its middle point.
double sag(int pieces, double kap) {
  constexpr double kLength = 1.1, kDensity = 0.5;
  Scene scene;
  BareYarn yarn;
  for (int i = 0; i <= pieces; ++i) {
    const double s = static_cast<double>(i) / pieces;
    yarn.points.push_back({s, -0.8 * s * (1.0 - s), 0.0});
    yarn.arc_lengths_m.push_back(kLength * s);
  }
  scene.yarns = {yarn};
  scene.yarn.linear_density_kg_per_m = kDensity;
  scene.yarn.stretch_n = kap * kDensity * kGravity * kLength;
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.handles = {pin(0, 0), pin(0, -1)};
  Simulation sim(checked_model(scene));
  advance(sim, 1.0, tight(1e-9, 1e-12 * scene.yarn.stretch_n));
  return -position(sim, 0, pieces / 2).y();
}

// Elastic catenary: D = H S/k_s + (2H/rho g) asinh(rho g S/(2H)),
// sag = rho g S^2/(8 k_s) + (H/rho g)(sqrt(1 + (rho g S/2H)^2) - 1).
constexpr double kSag100 = 0.207703789398;

TEST(Catenary, SagErrorFallsWithOrderTwo) {
  double before = 0.0;
  for (int pieces = 8; pieces <= 128; pieces *= 2) {
    const double error = sag(pieces, 100.0) - kSag100;
    // The chain's own error, 0.100/N^2, is known too.
    EXPECT_NEAR(std::abs(error) * pieces * pieces, 0.100, 0.0015) << pieces;
    if (before != 0.0) {
      EXPECT_NEAR(order(before, error), 2.0, 0.02) << pieces;
    }
    before = error;
  }
}

TEST(Catenary, SagFollowsTheStiffness) {
  EXPECT_NEAR(sag(128, 10.0), 0.257271417405, 1e-5);
  EXPECT_NEAR(sag(128, 1000.0), 0.201071943646, 1e-5);
}

TEST(Catenary, VerticalYarnStretchesExactly) {
  constexpr double kLength = 2.0, kDensity = 0.5, kStretch = 40.0;
  for (const int pieces : {1, 2, 7, 32}) {
    Scene scene;
    scene.yarns = {straight_yarn(Vec3::Zero(), {0.0, -kLength, 0.0}, pieces)};
    scene.yarn.linear_density_kg_per_m = kDensity;
    scene.yarn.stretch_n = kStretch;
    scene.effects.gravity.emplace();
    scene.effects.stretch.emplace();
    scene.handles = {pin(0, 0)};
    Simulation sim(checked_model(scene));
    advance(sim, 1.0, tight(1e-9, 2e-12));
    const double stretch = -position(sim, 0, -1).y() - kLength;
    EXPECT_NEAR(stretch, kDensity * kGravity * kLength * kLength / (2.0 * kStretch), 1e-11) << pieces;
  }
}

}  // namespace
}  // namespace slipstitch::testing
