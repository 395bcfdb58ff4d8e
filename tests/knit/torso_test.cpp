// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "collide/rigid_body.h"
#include "force/segments.h"
#include "sim/prepare.h"
#include "sim/simulation.h"
#include "support/energy_budget.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

struct Extent {
  Vec3 low, high;
};

Extent extent_of(const VecX& q, int nodes) {
  const Eigen::Map<const Eigen::Matrix3Xd> x(q.data(), 3, nodes);
  return {x.rowwise().minCoeff(), x.rowwise().maxCoeff()};
}

/// Of any point of the yarn, 10 to a segment, in the body [m].
double deepest_in(const RigidBody& body, const Simulation& sim) {
  const Topology& topology = sim.model().topology;
  const VecX& q = sim.state().q;
  double least = std::numeric_limits<double>::infinity();
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const Vec3 a = q.segment<3>(topology.x_coord(topology.visit_node[v])),
               b = q.segment<3>(topology.x_coord(topology.visit_node[v + 1]));
    for (int k = 0; k <= 10; ++k) least = std::min(least, body.distance(a + 0.1 * k * (b - a)).phi);
  });
  return sim.model().yarn.radius_m - least;
}

/// A tube held by its top, and a capsule a little too thick for it that comes up through it from below.
TEST(Torso, GoesIntoATubeThatIsTooNarrowForIt) {
  Scene scene = test::knit_scene("stockinette", 8, 16);
  scene.knit->pattern.in_the_round = true;
  test::use_demo_feel(scene.effects);
  scene.effects.gravity.emplace();
  scene.handles = {Handle{Edge::top, {}, false}};
  const Model empty = prepare(scene).model;
  double inner = 1.0;  // [m] clear radius inside the stitches
  Vec3 axis = Vec3::Zero();
  int stitch_nodes = 0;
  for (const Stitch& stitch : empty.topology.stitches)
    for (int node : stitch.node) {
      axis += empty.start_q.segment<3>(3 * node);
      ++stitch_nodes;
    }
  axis /= stitch_nodes;
  for (const Stitch& stitch : empty.topology.stitches)
    for (int node : stitch.node) {
      const Vec3 d = empty.start_q.segment<3>(3 * node) - axis;
      inner = std::min(inner, Vec3(d.x(), 0.0, d.z()).norm());
    }
  const double radius = 1.1 * inner, top = extent_of(empty.start_q, empty.topology.num_nodes).low.y() - 1e-3;
  const Vec3 up(0.0, 1.0, 0.0), tip(axis.x(), top - radius, axis.z());
  const double rise = 0.6 * (axis.y() - top) * 2.0;
  const Collider torso{Capsule{tip, tip - 0.1 * up, radius}, 0.1, {{0.0}, {0.25, rise * up}}};
  scene.effects.colliders.emplace().colliders = {torso};
  ASSERT_TRUE(check(scene).empty());

  Simulation sim(prepare(scene).model);
  RigidBody body(torso);
  double deepest = 0.0;
  test::EnergyBudget budget(sim);
  const double h = 1.0 / 240.0;
  for (int step = 1; step <= 60; ++step) {
    const StepReport report = sim.step(h, {}, {});
    ASSERT_TRUE(report.accepted) << "step " << step << ": " << to_string(report.newton.status);
    body.move_to(sim.state().t);
    budget.after_step(rise / 60.0 * up);
    deepest = std::max(deepest, deepest_in(body, sim));
  }
  int around = 0;  // stitches beside the cylinder: the tube is on, not pushed up ahead of it
  for (const Stitch& stitch : sim.model().topology.stitches) {
    const Vec3 in_body = body.to_body(sim.state().q.segment<3>(3 * stitch.node[0]));
    around += in_body.y() < tip.y();
  }
  std::printf("deepest %.3f radii; %d of %zu stitches around the cylinder\n", deepest / sim.model().yarn.radius_m,
              around, sim.model().topology.stitches.size());
  std::printf("energy %.2e above its bound, %.2e in a step\n", budget.excess(), budget.worst_step());
  EXPECT_LE(budget.excess(), 1e-9);
  EXPECT_LE(budget.worst_step(), 1e-9);
  EXPECT_LE(deepest, 0.1 * sim.model().yarn.radius_m);
  EXPECT_GT(around, 16);
}

}  // namespace
}  // namespace slipstitch
