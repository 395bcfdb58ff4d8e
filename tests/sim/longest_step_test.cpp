// SPDX-License-Identifier: MIT
#include "sim/longest_step.h"

#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

/// Of the hanging yarn, 1 mm thick, where a ball comes up to it at 1 m/s from below.
double longest_step_before_a_ball(double ball_radius_m, double below_m, double h) {
  Scene scene = hanging_yarn();
  Collider ball;
  ball.shape = Sphere{Vec3(0.1, -below_m - ball_radius_m, 0.0), ball_radius_m};
  ball.motion = {{1.0, {0.0, 1.0, 0.0}, Vec3::Zero()}};
  scene.effects.colliders.emplace().colliders = {ball};
  const Simulation sim(compile(scene, nullptr));
  return longest_step(sim, h);
}

TEST(LongestStep, LetsABodyComeLessThanARadius) {
  EXPECT_NEAR(longest_step_before_a_ball(0.05, 2e-3, 4e-3), 0.99 * 0.8e-3, 0.02e-3);
}

TEST(LongestStep, LetsAThinBodyComeNoFartherThanHalfOfWhatKeepsItOnItsSide) {
  EXPECT_NEAR(longest_step_before_a_ball(1e-4, 2e-3, 4e-3), 0.99 * 0.5 * 1.1e-3, 0.02e-3);
}

TEST(LongestStep, IsTheOneAskedForWhereNothingIsNearOrFast) {
  EXPECT_EQ(longest_step_before_a_ball(1e-4, 2e-3, 5e-4), 5e-4);
  EXPECT_EQ(longest_step_before_a_ball(1e-4, 0.5, 4e-3), 4e-3);
}

}  // namespace
}  // namespace slipstitch::testing
