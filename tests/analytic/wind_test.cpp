// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kDensity = 1e-3, kDrag = 2e-2;  // [kg/m], [N s/m^2]

Scene blown(const WindEffect& wind) {
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {0.2, 0.1, 0.0}, 4)};
  scene.yarn.linear_density_kg_per_m = kDensity;
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.air_drag = AirDragEffect{kDrag, 0.0};
  scene.effects.wind = wind;
  return scene;
}

TEST(Wind, TakesFreeYarnAlong) {
  const WindEffect wind{.velocity_m_per_s = {1.0, -2.0, 0.5}};
  Simulation sim(checked_model(blown(wind)));
  advance(sim, 100, 0.01, tight(1e-10, 0.0));  // 20 times the relaxation time rho/c1
  for (int n = 0; n < 5; ++n) EXPECT_LT((sim.state().v.segment<3>(3 * n) - wind.velocity_m_per_s).norm(), 1e-6);
}

// rho v' = c1 (gust sin(omega t) - v): |v| follows as 1/sqrt(1 + (omega tau)^2), atan(omega tau) behind, tau = rho/c1.
TEST(Wind, GustsComeWithTheirPeriod) {
  constexpr double kPeriod = 0.4, kOmega = 2.0 * kPi / kPeriod, kLag = kOmega * kDensity / kDrag;
  const Vec3 gust(0.0, 0.0, 0.3);
  const double amplitude = gust.z() / std::sqrt(1.0 + kLag * kLag);
  Simulation sim(checked_model(blown({.gust_velocity_m_per_s = gust, .gust_period_s = kPeriod})));
  constexpr int kStepsAPeriod = 400;
  double largest = 0.0;
  for (int n = 1; n <= 3 * kStepsAPeriod; ++n) {
    advance(sim, kPeriod / kStepsAPeriod, tight(1e-10, 0.0));
    if (n <= kStepsAPeriod) continue;  // the start has died away
    const double v = sim.state().v[2];
    largest = std::max(largest, std::abs(v));
    EXPECT_NEAR(v, amplitude * std::sin(kOmega * sim.state().t - std::atan(kLag)), 0.01 * amplitude);
  }
  EXPECT_NEAR(largest / amplitude, 1.0, 0.01);
}

}  // namespace
}  // namespace slipstitch::testing
