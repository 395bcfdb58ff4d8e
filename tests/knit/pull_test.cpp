// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdio>

#include "model/select.h"
#include "sim/prepare.h"
#include "sim/simulation.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

constexpr double kPullTime = 0.2;  // [s], then as long back

struct Pull {
  std::string name;
  Edge held, moved;
  Vec3 by;  // [m]
};

/// A 6x6 swatch, a quarter longer when pulled.
Scene pulled(const Pull& pull) {
  Scene scene = test::knit_scene("stockinette", 6, 6);
  test::use_demo_feel(scene.effects);
  scene.handles = {Handle{pull.held, {}, false},
                   Handle{pull.moved, {{0.0}, {kPullTime, pull.by}, {2.0 * kPullTime}}, false}};
  return scene;
}

/// Force of a handle's supports on the fabric along `direction` [N].
double force(const Simulation& sim, const Vec3& direction, const Handle& handle) {
  const VecX reactions = sim.reactions();
  double sum = 0.0;
  for (int node : select_nodes(handle.where, sim.model().topology))
    sum += direction.dot(reactions.segment<3>(3 * node));
  return sum;
}

class Pulled : public ::testing::TestWithParam<Pull> {};

TEST_P(Pulled, StretchesAndComesBackStepByStep) {
  const Pull& pull = GetParam();
  const Scene scene = pulled(pull);
  ASSERT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene, {}).model);
  const FixedNumerics numerics;
  const double h = numerics.time_step_s;
  double work = 0.0, before = 0.0, largest = 0.0;
  long newton_iterations = 0, steps = 0;
  for (double t = h; t < 2.0 * kPullTime + 0.5 * h; t += h, ++steps) {
    const StepReport report = sim.step(h, numerics, {});
    ASSERT_TRUE(report.accepted) << "t = " << t << " s: " << to_string(report.newton.status);
    newton_iterations += report.newton.iterations;
    const Vec3 along = pull.by.normalized();
    const double at_moved = force(sim, along, scene.handles[1]);
    work += (t < kPullTime + 0.5 * h ? 1.0 : -1.0) * at_moved * pull.by.norm() * h / kPullTime;
    largest = std::max(largest, at_moved);
    if (steps > 1) {
      EXPECT_NEAR(at_moved, -force(sim, along, scene.handles[0]), 0.05 * largest) << "t = " << t;
    }
    before = at_moved;
  }
  std::printf("%s: %.2f N at most, %.2f N at the end, %.2e J lost, %ld Newton iterations in %ld steps\n",
              pull.name.c_str(), largest, before, work, newton_iterations, steps);
  EXPECT_GT(largest, 0.0);
  EXPECT_GT(work, 0.0);
  EXPECT_LE(newton_iterations, 15 * steps);
}

INSTANTIATE_TEST_SUITE_P(Knit, Pulled,
                         ::testing::Values(Pull{"AlongTheWale", Edge::bottom, Edge::top, {0.0, 3e-3, 0.0}},
                                           Pull{"AlongTheCourse", Edge::left, Edge::right, {4e-3, 0.0, 0.0}}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace slipstitch
