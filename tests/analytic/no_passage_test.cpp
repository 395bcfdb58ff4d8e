// SPDX-License-Identifier: MIT
// Yarn does not pass through yarn or bodies, whatever moves and however fast.
#include "no_passage.h"

#include <algorithm>

#include "collide/closest_point.h"

namespace slipstitch::testing {
namespace {

/// A yarn along x, pinned at its ends, and one across it at z = height.
Scene crossed(double height) {
  Scene scene;
  scene.yarns = {straight_yarn({-0.03, 0, 0}, {0.03, 0, 0}, 30),
                 straight_yarn({2e-4, -0.01, height}, {2e-4, 0.01, height}, 10)};
  list_yarn_effects(scene);
  scene.effects.self_collision.emplace();
  scene.handles = {pin(0, 0), pin(0, -1)};
  return scene;
}

/// Distance of yarn 1's middle from yarn 0, negative once it is below, least over the run [m].
double least_distance(const Scene& scene, double duration_s) {
  double least = 1.0;
  run_watched(scene, duration_s, [&](const Simulation& sim) {
    const Vec3 b0 = position(sim, 1, 4), b1 = position(sim, 1, 6);
    Vec3 closest = Vec3::UnitZ();
    for (int i = 0; i < 30; ++i) {
      const Vec3 a0 = position(sim, 0, i), a1 = position(sim, 0, i + 1);
      const SegmentPair at = closest_of_segments(a0, a1, b0, b1);
      const Vec3 gap = b0 + at.t * (b1 - b0) - a0 - at.s * (a1 - a0);
      if (gap.norm() < closest.norm()) closest = gap;
    }
    least = std::min(least, std::copysign(closest.norm(), closest.z()));
  });
  return least;
}

// At 20 m/s yarn is stretched to twice its length in a step, and its points are as much farther apart.
TEST(NoPassage, YarnThrownAtYarnBouncesOff) {
  for (const auto& [speed, radii] : {std::pair(1.0, 1.5), std::pair(20.0, 0.75)}) {
    Scene scene = crossed(0.01);
    scene.yarns[1].velocity_m_per_s = {0, 0, -speed};
    EXPECT_GT(least_distance(scene, 0.03 / speed + 0.02), radii * kR) << speed;
  }
}

TEST(NoPassage, AHandleCarriesTheYarnAlongThatItMeets) {
  for (const double speed : {0.1, 0.3, 2.0}) {
    Scene scene = crossed(0.005);
    for (int point = 0; point <= 10; ++point) scene.handles.push_back(carried(YarnPoint{1, point}, {0, 0, -speed}));
    EXPECT_GT(least_distance(scene, 0.015 / speed), 1.5 * kR) << speed;
  }
}

TEST(NoPassage, YarnThatStartsWithinAThirdOfARadiusKeepsThatDistance) {
  Scene scene = crossed(0.33 * kR);
  scene.effects.gravity.emplace().acceleration_m_per_s2 = {0, 0, -9.81};
  EXPECT_GT(least_distance(scene, 0.05), 0.25 * kR);
}

TEST(NoPassage, ABodyMeetsYarnWhereItHasSlidAlso) {
  Scene scene = let_down();
  Collider ball;
  ball.shape = Sphere{{0.02, -0.035, 0}, 4e-3};
  ball.motion = {{0.5, Vec3::Zero(), Vec3::Zero()}, {1.0, {-0.04, 0, 0}, Vec3::Zero()}};
  scene.effects.colliders.emplace().colliders = {ball};
  EXPECT_LT(deepest(scene, 1.0), 0.2 * kR);  // deeper than at the points, between them
}

TEST(NoPassage, YarnMeetsYarnWhereItHasSlidAlso) {
  Scene scene = let_down();
  scene.effects.bending.emplace();
  scene.effects.self_collision.emplace();
  scene.yarns.push_back(straight_yarn({0.14, -0.035, -0.01}, {0.14, -0.035, 0.01}, 20));
  scene.yarns[1].velocity_m_per_s = {-0.2, 0, 0};
  double least = 1.0;
  run_watched(scene, 1.0, [&](const Simulation& sim) { least = std::min(least, position(sim, 1, 10).x()); });
  EXPECT_GT(least, 1.5 * kR);
  EXPECT_LT(least, 2.5 * kR);  // it came
}

/// A yarn along x that nothing holds, above a body that is flung at it.
Scene below(const Collider& collider) {
  Scene scene;
  scene.yarns = {straight_yarn({-0.03, 0, 0}, {0.03, 0, 0}, 30)};
  list_yarn_effects(scene);
  scene.handles = {pin(0, 0), pin(0, -1)};
  scene.effects.colliders.emplace().colliders = {collider};
  return scene;
}

TEST(NoPassage, AThinPlateAndASmallBallCarryYarnAlong) {
  for (const double speed : {0.4, 4.0}) {
    for (const Shape& shape :
         {Shape(Box{{0, 0, 5e-3}, {5e-3, 5e-3, 5e-4}, Vec3::Zero()}), Shape(Sphere{{0, 0, 8e-3}, 4e-3})}) {
      Collider collider;
      collider.shape = shape;
      collider.motion = {{0.02 / speed, {0, 0, -0.02}, Vec3::Zero()}};
      double lowest = 1.0;
      run_watched(below(collider), 0.02 / speed, [&](const Simulation& sim) { lowest = position(sim, 0, 15).z(); });
      EXPECT_LT(lowest, -0.0125) << speed << " m/s, shape " << shape.index();
    }
  }
}

// The motion ends in the middle of a step, so that the way of that step is shorter than its speed says.
TEST(NoPassage, APlateThatStopsWithinAStepHasTheYarnBeforeIt) {
  Collider collider;
  collider.shape = Box{{0, 0, 5e-3}, {5e-3, 5e-3, 5e-4}, Vec3::Zero()};
  collider.motion = {{6e-3, {0, 0, -0.012}, Vec3::Zero()}};
  double last = 1.0;
  run_watched(below(collider), 0.01, [&](const Simulation& sim) { last = position(sim, 0, 15).z(); });
  EXPECT_LT(last, -7e-3);
}

TEST(NoPassage, YarnThrownAtAThinPlateStaysOnItsSide) {
  Collider plate;
  plate.shape = Box{{0, 0, -0.02}, {0.1, 0.1, 2e-4}, Vec3::Zero()};
  Scene scene = below(plate);
  scene.handles.clear();
  scene.yarns[0].velocity_m_per_s = {0, 0, -20.0};
  double lowest = 1.0;
  run_watched(scene, 0.05, [&](const Simulation& sim) {
    for (int i = 0; i <= 30; ++i) lowest = std::min(lowest, position(sim, 0, i).z());
  });
  EXPECT_GT(lowest, -0.02);
}

}  // namespace
}  // namespace slipstitch::testing
