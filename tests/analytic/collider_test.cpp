// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "collide/rigid_body.h"
#include "sim/prepare.h"
#include "sim/simulation.h"
#include "support/energy_budget.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

constexpr double kG = 9.81;

/// A straight yarn that lies along z on a slope falling towards +x.
Scene yarn_on_slope(double angle, double friction) {
  Scene scene;
  const Vec3 normal(std::sin(angle), std::cos(angle), 0.0);
  BareYarn yarn;
  for (int i = 0; i < 6; ++i) yarn.points.push_back(scene.yarn.radius_m * normal + Vec3(0.0, 0.0, 4e-3 * i));
  scene.yarns = {yarn};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.colliders.emplace().colliders = {{Plane{Vec3::Zero(), normal}, friction, {}}};
  return scene;
}

/// Mean velocity down the slope after each of `steps` steps of 1/240 s.
std::vector<double> velocities(const Scene& scene, double angle, int steps) {
  EXPECT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  const Vec3 down(std::cos(angle), -std::sin(angle), 0.0);
  const int nodes = sim.model().topology.num_nodes;
  std::vector<double> result;
  for (int k = 0; k < steps; ++k) {
    EXPECT_TRUE(sim.step(1.0 / 240.0, {}, {}).accepted) << k;
    double sum = 0.0;
    for (int n = 0; n < nodes; ++n) sum += down.dot(sim.state().v.segment<3>(3 * n));
    result.push_back(sum / nodes);
  }
  return result;
}

TEST(Slope, SticksBelowTheAngleOfFriction) {
  const double mu = 0.3, angle = std::atan(mu) - 0.01;
  const auto v = velocities(yarn_on_slope(angle, mu), angle, 240);
  double way = 0.0;  // but for the first steps: what was not touched before slides until it is
  for (std::size_t k = 10; k < v.size(); ++k) way += v[k] / 240.0;
  EXPECT_LT(std::abs(way), 1e-6);
  EXPECT_LT(std::abs(v.back()), 1e-6);
}

TEST(Slope, SlidesAboveItAsCoulombSays) {
  for (double mu : {0.0, 0.3}) {
    const double angle = std::atan(mu) + 0.05;
    const auto v = velocities(yarn_on_slope(angle, mu), angle, 120);
    const double acceleration = (v[119] - v[59]) * 240.0 / 60.0;
    const double expected = kG * (std::sin(angle) - mu * std::cos(angle));
    std::printf("friction %.1f: %.4f m/s^2 down the slope, expected %.4f\n", mu, acceleration, expected);
    EXPECT_NEAR(acceleration, expected, 0.01 * expected);
  }
}

// From rest on a belt that runs at v: carried by mu g until it moves along, it is v^2/(2 mu g) behind by then.
TEST(Belt, CarriesWhatLiesOnItAlong) {
  const double mu = 0.3, v = 0.2, end = 0.15;
  Scene scene = yarn_on_slope(0.0, mu);
  Collider& belt = scene.effects.colliders->colliders[0];
  belt.shape = Box{{0.0, -0.01, 0.0}, {0.2, 0.01, 0.2}, Vec3::Zero()};
  belt.motion = {{0.0, Vec3::Zero(), Vec3::Zero()}, {1.0, v * Vec3::UnitX(), Vec3::Zero()}};
  EXPECT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  const int nodes = sim.model().topology.num_nodes;
  const auto mean_x = [&](const VecX& of) {
    double sum = 0.0;
    for (int n = 0; n < nodes; ++n) sum += of[3 * n] / nodes;
    return sum;
  };
  const double start = mean_x(sim.state().q);
  for (int k = 0; k < 600; ++k) ASSERT_TRUE(sim.step(end / 600.0, {}, {}).accepted) << k;
  const double behind = v * end - (mean_x(sim.state().q) - start), expected = v * v / (2.0 * mu * kG);
  std::printf("%.3f mm behind the belt, expected %.3f mm\n", 1e3 * behind, 1e3 * expected);
  EXPECT_NEAR(behind, expected, 0.01 * expected);
  EXPECT_NEAR(mean_x(sim.state().v), v, 1e-3 * v);
}

TEST(Slope, HasFrictionStencilsOnlyWhereThereIsFriction) {
  for (double mu : {0.0, 0.3}) {
    Simulation sim(prepare(yarn_on_slope(0.1, mu)).model);
    for (int k = 0; k < 20; ++k) ASSERT_TRUE(sim.step(1.0 / 240.0, {}, {}).accepted) << k;
    EXPECT_GT(sim.effect_costs().at("colliders").stencils, 0);
    EXPECT_EQ(sim.effect_costs().contains("collider_friction"), mu > 0.0);
  }
}

/// How far a swatch goes down a plane that is tilted by `angle` between 0.15 s, when it has settled, and 0.25 s [m].
/// Without wrapping it stays flat; one that curls gets up on its edges and topples.
double way_of_swatch(double angle, double friction) {
  Scene scene = test::knit_scene("stockinette", 5, 5);
  test::use_demo_feel(scene.effects);
  scene.effects.wrapping.reset();
  scene.effects.gravity.emplace().acceleration_m_per_s2 = kG * Vec3(std::sin(angle), 0.0, -std::cos(angle));
  scene.effects.colliders.emplace().colliders = {
      {Plane{-scene.yarn.radius_m * Vec3::UnitZ(), Vec3::UnitZ()}, friction, {}}};
  EXPECT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  const int nodes = sim.model().topology.num_nodes;
  const auto place = [&] {
    double sum = 0.0;
    for (int n = 0; n < nodes; ++n) sum += sim.state().q[3 * n];
    return sum / nodes;
  };
  test::EnergyBudget budget(sim);
  double settled = 0.0;
  for (int step = 0; step < 60; ++step) {
    if (step == 36) settled = place();
    EXPECT_TRUE(sim.step(1.0 / 240.0, {}, {}).accepted) << step;
    budget.after_step();
  }
  std::printf("energy %.2e above its bound, %.2e in a step\n", budget.excess(), budget.worst_step());
  EXPECT_LE(budget.excess(), 1e-9);
  EXPECT_LE(budget.worst_step(), 1e-9);
  return place() - settled;
}

TEST(Slope, CarriesASwatchUpToTheAngleOfFriction) {
  const double mu = 0.3, limit = std::atan(mu);
  const double sticks = way_of_swatch(limit - 0.05, mu), slides = way_of_swatch(limit + 0.05, mu);
  const double expected =
      0.5 * kG * (std::sin(limit + 0.05) - mu * std::cos(limit + 0.05)) * (0.25 * 0.25 - 0.15 * 0.15);
  std::printf("%.3f mm below the angle, %.2f mm above it (a block: %.2f mm)\n", 1e3 * sticks, 1e3 * slides,
              1e3 * expected);
  EXPECT_LT(std::abs(sticks), 0.02 * slides);
  EXPECT_GT(slides, 0.8 * expected);
  EXPECT_LT(slides, 1.2 * expected);
}

/// Deepest overlap of any of the yarns with a body, at points 20 to a segment [m].
double deepest(const Simulation& sim, const RigidBody& body) {
  const Topology& topology = sim.model().topology;
  double least = 1.0;
  for (int i = 0; i + 1 < topology.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology.segment_kind[v] == SegmentKind::none) continue;
    const Vec3 a = sim.state().q.segment<3>(3 * topology.visit_node[v]),
               b = sim.state().q.segment<3>(3 * topology.visit_node[v + 1]);
    for (int k = 0; k <= 20; ++k) least = std::min(least, body.distance(a + k / 20.0 * (b - a)).phi);
  }
  return sim.model().yarn.radius_m - least;
}

Scene swatch_above(const Collider& collider) {
  Scene scene = test::knit_scene("stockinette", 10, 10);
  scene.knit->placement.origin_m = Vec3(-10.5e-3, 0.0, 10e-3);
  scene.knit->placement.wale_direction = Vec3(0.0, 0.0, -1.0);
  scene.effects.gravity.emplace();
  test::use_demo_feel(scene.effects);
  scene.effects.colliders.emplace().colliders = {collider};
  return scene;
}

/// One step, or several in its place where it does not converge; `visit` sees every accepted one.
void advance(Simulation& sim, double h, const std::function<void()>& visit, int cuts = 0) {
  const StepReport report = sim.step(h, {}, {});
  if (report.accepted) return visit();
  ASSERT_LT(cuts, 4) << "t = " << sim.state().t << ": " << to_string(report.newton.status);
  for (int half = 0; half < 2; ++half) advance(sim, 0.5 * h, visit, cuts + 1);
}

/// Steps for `duration`; no accepted step may leave yarn deeper in the body than a tenth of its radius.
void expect_never_inside(Simulation& sim, const Collider& collider, double duration) {
  RigidBody body(collider);
  test::EnergyBudget budget(sim);
  double worst = -1.0;
  const double h = 1.0 / 240.0;
  double t_last = 0.0;
  for (double t = h; t < duration + 0.5 * h; t += h) {
    advance(sim, h, [&] {
      const Vec3 before = motion_at(collider.motion, t_last).translation_m;
      t_last = sim.state().t;
      budget.after_step(motion_at(collider.motion, t_last).translation_m - before);
      body.move_to(t_last);
      worst = std::max(worst, deepest(sim, body));
    });
  }
  std::printf("deepest overlap %.3f radii; energy %.2e above its bound, %.2e in a step\n",
              worst / sim.model().yarn.radius_m, budget.excess(), budget.worst_step());
  EXPECT_LE(budget.excess(), 1e-9);
  EXPECT_LE(budget.worst_step(), 1e-9);
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, 0.1 * sim.model().yarn.radius_m);
}

TEST(Ball, CarriesASwatchThatFallsOnIt) {
  const Collider ball{Sphere{{0.0, -12e-3, 0.0}, 10e-3}, 0.3, {}};
  const Scene scene = swatch_above(ball);
  ASSERT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  expect_never_inside(sim, ball, 0.25);
}

TEST(Ball, LiftsASwatchThatIsHeldAtItsEdges) {
  const Collider ball{Sphere{{0.0, -8e-3, 0.0}, 4e-3}, 0.3, {{0.0}, {0.2, {0.0, 6e-3, 0.0}}}};
  Scene scene = swatch_above(ball);
  scene.handles = {Handle{Edge::left, {}, false}, Handle{Edge::right, {}, false}};
  ASSERT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  expect_never_inside(sim, ball, 0.2);
  EXPECT_GT(sim.state().q(1 + 3 * sim.model().topology.stitches[45].node[0]),
            1e-3);  // over the ball, whose top ends at y = 2 mm
}

}  // namespace
}  // namespace slipstitch
