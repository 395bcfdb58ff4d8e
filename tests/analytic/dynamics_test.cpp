// SPDX-License-Identifier: MIT
#include <array>

#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kGravity = 9.81;

TEST(FreeFall, IsExactlyImplicitEuler) {
  const Vec3 v0(0.3, 2.0, -0.7);
  Scene scene;
  BareYarn yarn = straight_yarn(Vec3(0.1, 0.2, 0.3), {0.4, 0.25, 0.2}, 6);
  yarn.velocity_m_per_s = v0;
  scene.yarns = {yarn};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  Simulation sim(checked_model(scene));
  constexpr double kStep = 0.01;
  for (int n = 1; n <= 100; ++n) {
    advance(sim, kStep, tight(1e-9, 0.0));
    const double t = n * kStep;
    const Vec3 fall = v0 * t + Vec3(0.0, -0.5 * kGravity * t * (t + kStep), 0.0);
    for (int i = 0; i < 7; ++i) {
      const Vec3 start = yarn.points[static_cast<std::size_t>(i)];
      ASSERT_LT((position(sim, 0, i) - start - fall).norm(), 1e-11) << "point " << i << " at " << t;
    }
  }
  EXPECT_NEAR(position(sim, 0, 0).y() - 0.2 - 2.0, -4.95405, 1e-11);
}

/// A rigid rod of one segment, hinged at its upper end, released at rest from `amplitude` [rad] off the vertical.
Scene rod(double amplitude) {
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {std::sin(amplitude), -std::cos(amplitude), 0.0}, 1)};
  scene.yarn.linear_density_kg_per_m = 0.2;
  scene.yarn.stretch_n = 1e7 * 0.2 * kGravity;
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.handles = {pin(0, 0)};
  return scene;
}

/// Time at which the angle passes zero, on the cubic through the four instants around it.
double zero_of_cubic(const std::array<double, 4>& t, const std::array<double, 4>& angle) {
  double time = 0.0;  // Lagrange, t as a function of the angle
  for (std::size_t i = 0; i < 4; ++i) {
    double weight = 1.0;
    for (std::size_t j = 0; j < 4; ++j)
      if (j != i) weight *= -angle[j] / (angle[i] - angle[j]);
    time += weight * t[i];
  }
  return time;
}

/// Four times the time from the release to the lowest point.
double period(double amplitude, double h) {
  Simulation sim(checked_model(rod(amplitude)));
  std::array<double, 4> t{}, angle{};
  for (int n = 0; n < 100000 && !(angle[2] < 0.0 && angle[1] > 0.0); ++n) {
    advance(sim, h, tight(1e-9, 0.0));
    if (::testing::Test::HasFatalFailure()) return 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = t[i + 1];
      angle[i] = angle[i + 1];
    }
    const Vec3 x = position(sim, 0, 1);
    t[3] = sim.state().t;
    angle[3] = std::atan2(x.x(), -x.y());
  }
  return 4.0 * zero_of_cubic(t, angle);
}

// T0 of a uniform rod about its end 2 pi sqrt(2 l/(3 g)); T/T0 = (2/pi) K(sin(amplitude/2)). Lumped mass would give the
// period of a point mass, 22 % longer.
TEST(Pendulum, PeriodIsThatOfARod) {
  constexpr double kSmall = 1.63794658591;
  const std::array<std::array<double, 2>, 3> table = {
      {{10.0, 1.00190718814}, {60.0, 1.07318200715}, {120.0, 1.37288050062}}};
  for (const auto& [degrees, ratio] : table) {
    const double amplitude = degrees * kPi / 180.0;
    constexpr double kStep = kSmall / 400;
    const double measured =
        extrapolated(period(amplitude, kStep), period(amplitude, kStep / 2), period(amplitude, kStep / 4));
    EXPECT_NEAR(measured / (kSmall * ratio), 1.0, 1e-5) << degrees;
  }
}

/// A soft hanging yarn let go from the horizontal: every effect of a plain yarn at work, nothing that switches.
VecX swung(double h, double end) {
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {0.2, 0.05, 0.03}, 6)};
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1e-2, .stretch_n = 0.5, .bending_nm2 = 1e-5};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.handles = {pin(0, 0)};
  Simulation sim(checked_model(scene));
  advance(sim, static_cast<int>(std::lround(end / h)), h, tight(1e-9, 0.0));
  return sim.state().q;
}

TEST(ImplicitEuler, IsOfFirstOrderInTime) {
  constexpr double kEnd = 0.1, kStep = 1e-3;
  const VecX q1 = swung(kStep, kEnd), q2 = swung(kStep / 2, kEnd), q4 = swung(kStep / 4, kEnd),
             q8 = swung(kStep / 8, kEnd);
  const double first = (q1 - q2).norm(), second = (q2 - q4).norm(), third = (q4 - q8).norm();
  EXPECT_GT(first, 1e-5);  // there is an error to measure
  EXPECT_NEAR(order(first, second), 1.0, 0.1);
  EXPECT_NEAR(order(second, third), 1.0, 0.05);
}

}  // namespace
}  // namespace slipstitch::testing
