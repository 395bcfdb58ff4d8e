// SPDX-License-Identifier: MIT
#include "force/bending_jamming.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/loop_run.h"
#include "model/refine.h"

namespace slipstitch {
namespace {

constexpr int kSegments = 8;
constexpr double kLength = 1e-3;  // of a segment [m]

/// A yarn of that many free segments on a circle.
Model circle(double curvature, int extra) {
  Topology coarse;
  coarse.yarn_first = {0, kSegments + 1};
  for (int i = 0; i <= kSegments; ++i) add_visit(coarse, coarse.num_nodes++, false, i * kLength);
  coarse.yarn_material = {0};
  coarse.density_scale = {1.0};
  mark_segments(coarse);
  Model model;
  model.topology = refine(coarse, extra).topology;
  model.effects.bending.emplace();
  model.effects.bending_jamming.emplace();
  model.start_q.resize(model.topology.num_coords());
  for (int i = 0; i < model.topology.num_visits(); ++i) {
    const double arc = model.topology.rest_arc[static_cast<std::size_t>(i)], angle = curvature * arc;
    model.start_q.segment<3>(model.topology.x_coord(model.topology.visit_node[static_cast<std::size_t>(i)])) =
        Vec3(std::cos(angle), std::sin(angle), 0.0) / curvature;
    model.start_q[model.topology.arc_coord(i)] = arc;
  }
  return model;
}

/// Energy over the arc length that its bends span [J/m].
double density(const Model& model) {
  const BendingJamming term(model);
  double energy = 0.0, arc = 0.0;
  for (int k = 0; k < term.size(); ++k) {
    Vec<11> q;
    const auto coords = term.coords(k);
    for (int i = 0; i < 11; ++i) q[i] = model.start_q[coords[static_cast<std::size_t>(i)]];
    energy += term.eval(k, q, nullptr, nullptr);
    arc += q[10] - q[3];
  }
  return energy / arc;
}

// It begins at the curvature at which the yarn without extra nodes has a right angle.
TEST(BendingJamming, ActsAtTheSameCurvatureHoweverFineTheYarn) {
  const double kappa_j = kPi / (2.0 * kLength);
  EXPECT_EQ(density(circle(0.999 * kappa_j, 0)), 0.0);
  EXPECT_EQ(density(circle(0.999 * kappa_j, 3)), 0.0);
  const double coarse = density(circle(1.3 * kappa_j, 0));
  EXPECT_GT(coarse, 0.0);
  for (const int extra : {1, 3, 8}) EXPECT_NEAR(density(circle(1.3 * kappa_j, extra)), coarse, 1e-9 * coarse) << extra;
}

}  // namespace
}  // namespace slipstitch
