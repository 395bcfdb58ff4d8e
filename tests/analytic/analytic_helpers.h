// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "sim/simulation.h"

namespace slipstitch::testing {

/// Far below every quantity tested; steps that need many iterations may take them.
inline FixedNumerics tight(double velocity_m_per_s, double force_n) {
  FixedNumerics numerics;
  numerics.velocity_tolerance_m_per_s = velocity_m_per_s;
  numerics.force_tolerance_n = force_n;
  numerics.max_newton_iterations = 1000;
  return numerics;
}

inline Model checked_model(const Scene& scene) {
  for (const Issue& issue : check(scene))
    ADD_FAILURE() << issue.path << ": " << issue.value << ", not " << issue.expected;
  return compile(scene, nullptr);
}

/// N equal pieces of a straight line from a to b: N + 1 points.
inline std::vector<Vec3> line(const Vec3& a, const Vec3& b, int pieces) {
  std::vector<Vec3> points;
  for (int i = 0; i <= pieces; ++i) points.push_back(a + (b - a) * (static_cast<double>(i) / pieces));
  return points;
}

inline BareYarn straight_yarn(const Vec3& a, const Vec3& b, int pieces) {
  BareYarn yarn;
  yarn.points = line(a, b, pieces);
  return yarn;
}

inline Handle pin(int yarn, int point) { return Handle{YarnPoint{yarn, point}, {}, false}; }

inline int visit_of(const Simulation& sim, int yarn, int point) {
  const auto& first = sim.model().topology.yarn_first;
  const auto y = static_cast<std::size_t>(yarn);
  return point >= 0 ? first[y] + point : first[y + 1] + point;
}
inline Vec3 position(const Simulation& sim, int yarn, int point) {
  const Topology& topo = sim.model().topology;
  const int node = topo.visit_node[static_cast<std::size_t>(visit_of(sim, yarn, point))];
  return sim.state().q.segment<3>(topo.x_coord(node));
}
inline double arc(const Simulation& sim, int yarn, int point) {
  return sim.state().q[sim.model().topology.arc_coord(visit_of(sim, yarn, point))];
}
/// Tension k_s (|dx|/du - 1) of the piece behind a point [N].
inline double tension(const Simulation& sim, int yarn, int point) {
  const double du = arc(sim, yarn, point + 1) - arc(sim, yarn, point);
  return sim.model().yarn.stretch_n * ((position(sim, yarn, point + 1) - position(sim, yarn, point)).norm() / du - 1.0);
}

/// One step that must be accepted.
inline void advance(Simulation& sim, double h, const FixedNumerics& numerics) {
  const StepReport report = sim.step(h, numerics, {});
  ASSERT_TRUE(report.accepted) << to_string(report.newton.status) << " at t = " << sim.state().t << ", residual "
                               << report.residual << " after " << report.newton.iterations << " iterations";
}
inline void advance(Simulation& sim, int steps, double h, const FixedNumerics& numerics) {
  for (int i = 0; i < steps && !::testing::Test::HasFatalFailure(); ++i) advance(sim, h, numerics);
}

/// Order p of errors that fall like (1/2)^p from one level to the next.
inline double order(double coarse_error, double fine_error) { return std::log2(std::abs(coarse_error / fine_error)); }

/// Limit h -> 0 of values at h, h/2, h/4 whose error is a h + b h^2.
inline double extrapolated(double at_h, double at_half, double at_quarter) {
  return (8.0 * at_quarter - 6.0 * at_half + at_h) / 3.0;
}

}  // namespace slipstitch::testing
