// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "sim/prepare.h"
#include "sim/simulation.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

/// Mean distance of a course's nodes from the tube's axis [m].
double radius_of_course(const Simulation& sim, int course) {
  Eigen::Matrix3Xd nodes(3, 0);
  for (const Stitch& stitch : sim.model().topology.stitches) {
    if (stitch.course != course) continue;
    for (int node : stitch.node) {
      if (node < 0) continue;
      nodes.conservativeResize(3, nodes.cols() + 1);
      nodes.rightCols<1>() = sim.state().q.segment<3>(3 * node);
    }
  }
  nodes.colwise() -= Vec3(nodes.rowwise().mean());
  nodes.row(1).setZero();
  return nodes.colwise().norm().mean();
}

TEST(Tube, HangsFromItsTopAndFlaresAtItsHem) {
  constexpr int kCourses = 8;
  Scene scene = test::knit_scene("stockinette", kCourses, 12);
  scene.knit->pattern.in_the_round = true;
  scene.effects.gravity.emplace();
  test::use_demo_feel(scene.effects);
  scene.handles = {Handle{Edge::top, {}, false}};
  ASSERT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  const double hem = radius_of_course(sim, 1), middle = radius_of_course(sim, kCourses / 2);
  EXPECT_NEAR(hem, middle, 0.01 * middle);
  for (int step = 0; step < 60; ++step) {
    const StepReport report = sim.step(1.0 / 120.0, {}, {});
    ASSERT_TRUE(report.accepted) << "step " << step << ": " << to_string(report.newton.status);
  }
  // The edge curls to the knit side, which is outside; the rest stays a tube.
  EXPECT_GT(radius_of_course(sim, 1), 1.3 * radius_of_course(sim, kCourses / 2));
  EXPECT_NEAR(radius_of_course(sim, kCourses / 2), middle, 0.15 * middle);
}

}  // namespace
}  // namespace slipstitch
