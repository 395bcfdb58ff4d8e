// SPDX-License-Identifier: MIT
// Spheres that forces move.
#include <cstdio>

#include "analytic_helpers.h"
#include "sim/body_motion.h"
#include "sim/handle_forces.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "support/knit_scene.h"

namespace slipstitch::testing {
namespace {

constexpr double kG = 9.81;

Collider ball(const Vec3& centre, double radius, double mass, double friction, const Vec3& velocity = Vec3::Zero()) {
  return {Sphere{centre, radius}, friction, {}, DynamicBody{mass, velocity}};
}

Scene yarns_and(const Collider& collider, const std::vector<BareYarn>& yarns) {
  Scene scene;
  scene.yarns = yarns;
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.colliders.emplace().colliders = {collider};
  return scene;
}

BodyMotion the_body(const Simulation& sim) { return body_motions(sim).at(0); }

/// Deepest overlap of yarn and the sphere, at points 20 to a segment [m].
double overlap(const Simulation& sim) {
  const Topology& topology = sim.model().topology;
  const Vec3 centre = the_body(sim).position_m;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i + 1 < topology.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology.segment_kind[v] == SegmentKind::none) continue;
    const Vec3 a = sim.state().q.segment<3>(3 * topology.visit_node[v]),
               b = sim.state().q.segment<3>(3 * topology.visit_node[v + 1]);
    for (int k = 0; k <= 20; ++k) least = std::min(least, (a + k / 20.0 * (b - a) - centre).norm());
  }
  return sim.model().yarn.radius_m + sim.model().bodies.at(0).radius_m - least;
}

TEST(Body, FallsFreelyAsImplicitEulerDoes) {
  Scene scene = yarns_and(ball({0.0, 1.0, 0.0}, 0.01, 0.02, 0.3, {1.0, 2.0, -0.5}),
                          {straight_yarn({0.0, 0.0, 0.5}, {0.1, 0.0, 0.5}, 4)});
  scene.effects.gravity.emplace();
  Simulation sim(checked_model(scene));
  EXPECT_EQ(sim.num_dofs(), 3 * 6);
  const double h = 1e-3;
  for (int n = 1; n <= 100; ++n) {
    advance(sim, h, tight(1e-9, 1e-9));
    const Vec3 g(0.0, -kG, 0.0);
    const Vec3 v = Vec3(1.0, 2.0, -0.5) + n * h * g;
    const Vec3 x = Vec3(0.0, 1.0, 0.0) + n * h * Vec3(1.0, 2.0, -0.5) + 0.5 * n * (n + 1) * h * h * g;
    const double unit = std::numeric_limits<double>::epsilon() * x.norm();  // rounding of x, once a step
    EXPECT_LE((the_body(sim).velocity_m_per_s - v).norm(), unit * n / h) << n;
    EXPECT_LE((the_body(sim).position_m - x).norm(), unit * n * n) << n;
  }
  const auto energies = sim.energies();
  const double speed2 = the_body(sim).velocity_m_per_s.squaredNorm();
  EXPECT_GT(energies.at("kinetic"), 0.5 * 0.02 * speed2);
  EXPECT_NEAR(energies.at("body_gravity"), 0.02 * kG * the_body(sim).position_m.y(), 1e-12);
}

Vec3 momentum(const Simulation& sim) {
  Vec3 sum = Vec3::Zero();
  for (int n = 0; n < sim.model().topology.num_nodes; ++n) sum += sim.state().p.segment<3>(3 * n);
  return sum;
}

TEST(Body, AndTheYarnThatItHitsKeepTheirMomentum) {
  Scene scene = yarns_and(ball({0.05, 0.01, 0.001}, 5e-3, 2e-5, 0.4, {0.5, -2.0, 0.1}),
                          {straight_yarn({0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, 20)});
  Simulation sim(checked_model(scene));
  const Vec3 start = momentum(sim);
  EXPECT_LE((start - 2e-5 * Vec3(0.5, -2.0, 0.1)).norm(), 1e-18);
  const double h = 2e-4;
  double hardest = 0.0;
  for (int n = 0; n < 100; ++n) {
    advance(sim, h, tight(1e-8, 1e-9));
    EXPECT_LE((momentum(sim) - start).norm(), 1e-7 * start.norm()) << n;
    hardest = std::max(hardest, overlap(sim));
    EXPECT_LE(overlap(sim), 0.1 * scene.yarn.radius_m) << n;
  }
  const Vec3 lost = 2e-5 * (Vec3(0.5, -2.0, 0.1) - the_body(sim).velocity_m_per_s);
  std::printf("momentum drift %.1e, given to the yarn %.3f, %.3f of all\n",
              (momentum(sim) - start).norm() / start.norm(), lost.y() / start.y(), lost.x() / start.x());
  EXPECT_GT(hardest, 0.0);
  EXPECT_GT(lost.y() / start.y(), 0.01);
  EXPECT_GT(lost.x() / start.x(), 0.01);  // friction took the yarn along
}

TEST(Body, RestsInAHammockWhoseHandlesCarryIt) {
  const double mass = 2e-3, span = 0.06;
  Scene scene = yarns_and(ball({0.5 * span, 5.1e-3, 0.0}, 5e-3, mass, 0.3),
                          {straight_yarn({0.0, 0.0, -2e-3}, {span, 0.0, -2e-3}, 24),
                           straight_yarn({0.0, 0.0, 2e-3}, {span, 0.0, 2e-3}, 24)});
  for (int yarn : {0, 1})
    for (int point : {0, 24}) scene.handles.push_back(pin(yarn, point));
  scene.effects.gravity.emplace();
  scene.effects.damping = DampingEffect{.stretch_ns = 0.5, .bending_nm2s = 1e-7, .sliding_ns_per_m = {}};
  Simulation sim(checked_model(scene));
  HandleForces forces(sim, scene.handles.size());
  advance(sim, 600, 1.0 / 240.0, tight(1e-7, 1e-9));
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : forces.observe(sim)) sum += force;
  const double weight = kG * (mass + 2.0 * span * scene.yarn.linear_density_kg_per_m);
  const BodyMotion at = the_body(sim);
  std::printf("rests at y = %.3f mm with %.1e m/s, overlap %.3f radii; handles carry %.6f of the weight\n",
              1e3 * at.position_m.y(), at.velocity_m_per_s.norm(), overlap(sim) / scene.yarn.radius_m,
              sum.y() / weight);
  EXPECT_LT(at.velocity_m_per_s.norm(), 1e-4);
  EXPECT_GT(overlap(sim), 0.0);
  EXPECT_LE(overlap(sim), 0.1 * scene.yarn.radius_m);
  EXPECT_NEAR(sum.y(), weight, 1e-3 * weight);
  EXPECT_NEAR(sum.x(), 0.0, 1e-3 * weight);
  EXPECT_NEAR(sum.z(), 0.0, 1e-3 * weight);
}

/// A yarn that nothing holds, above a fixed ball; what comes down on it is still to be added.
Scene yarn_above_a_ball() {
  Scene scene = yarns_and(Collider{Sphere{{0.01, -0.2, 0.0}, 0.01}, 0.3, {}},
                          {straight_yarn({0.0, 0.0, 0.0}, {0.02, 0.0, 0.0}, 10)});
  scene.duration_s = 0.2;
  return scene;
}

TEST(Body, PinchesYarnAgainstABallAndBouncesOff) {
  Scene scene = yarn_above_a_ball();
  scene.effects.colliders->colliders.push_back(ball({0.01, 0.02, 0.0}, 5e-3, 0.01, 0.3, {0.0, -2.0, 0.0}));
  ASSERT_TRUE(check(scene).empty());
  double deepest = -1.0, speed = 0.0;
  RunHooks hooks;
  hooks.on_step = [&](Simulation& sim, const StepReport& report) {
    if (!report.accepted) return;
    deepest = std::max(deepest, overlap(sim));
    speed = the_body(sim).velocity_m_per_s.y();
  };
  const RunSummary summary = run(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  std::printf("pinched %.3f radii deep, back at %.2f m/s\n", deepest / scene.yarn.radius_m, speed);
  EXPECT_GT(deepest, 0.05 * scene.yarn.radius_m);
  EXPECT_LE(deepest, 0.1 * scene.yarn.radius_m);
  EXPECT_GT(speed, 0.0);
}

TEST(Body, AScriptThatLeavesYarnNoRoomIsNamed) {
  Scene scene = yarn_above_a_ball();
  const std::vector<Keyframe> through{{0.0, Vec3::Zero(), Vec3::Zero()}, {0.2, {0.0, -0.22, 0.0}, Vec3::Zero()}};
  scene.effects.colliders->colliders.push_back(Collider{Sphere{{0.01, 0.02, 0.0}, 5e-3}, 0.3, through});
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_NE(summary.message.find("colliders leaves no room for point 4 of yarn 0"), std::string::npos)
      << summary.message;
}

/// One step, or several in its place where it does not converge; `visit` sees every accepted one.
template <class Visit>
void advance_cutting(Simulation& sim, double h, const Visit& visit, int cuts = 0) {
  const StepReport report = sim.step(h, {}, {});
  if (report.accepted) return visit();
  ASSERT_LT(cuts, 10) << "t = " << sim.state().t << ": " << to_string(report.newton.status);
  for (int half = 0; half < 2; ++half) advance_cutting(sim, 0.5 * h, visit, cuts + 1);
}

/// A sphere thrown at 20 m/s at a swatch that is held at its edges, in steps of h.
void throw_at_swatch(double h, int steps) {
  Scene scene = test::knit_scene("stockinette", 6, 6);
  test::use_demo_feel(scene.effects);
  for (const Edge edge : {Edge::bottom, Edge::top, Edge::left, Edge::right})
    scene.handles.push_back(Handle{edge, {}, false});
  const Model still = prepare(scene).model;
  Vec3 middle = Vec3::Zero();
  for (int n = 0; n < still.topology.num_nodes; ++n)
    middle += still.start_q.segment<3>(3 * n) / still.topology.num_nodes;
  scene.effects.colliders.emplace().colliders = {
      ball(middle + Vec3(0.0, 0.0, 0.03), 4e-3, 1e-3, 0.3, {0.0, 0.0, -20.0})};
  ASSERT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  double worst = -1.0, lowest = 1.0;
  for (int n = 0; n < steps; ++n) {
    advance_cutting(sim, h, [&] {
      worst = std::max(worst, overlap(sim));
      lowest = std::min(lowest, the_body(sim).position_m.z());
    });
  }
  const BodyMotion end = the_body(sim);
  std::printf("deepest overlap %.3f radii, %.1f mm beyond the middle of the swatch, back at %.2f m/s\n",
              worst / scene.yarn.radius_m, 1e3 * (middle.z() - lowest), end.velocity_m_per_s.z());
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, 0.1 * scene.yarn.radius_m);
  EXPECT_GT(end.velocity_m_per_s.z(), 0.0);
  EXPECT_GT(end.position_m.z(), middle.z());
}

TEST(Body, AtTwentyMetresASecondDoesNotPassThroughAHeldSwatchInOneStep) { throw_at_swatch(1.0 / 240.0, 12); }

TEST(Body, AtTwentyMetresASecondDoesNotPassThroughAHeldSwatchInManySteps) { throw_at_swatch(5e-5, 100); }

/// Two rails of yarn along x that a handle moves along x, and a sphere on them.
struct Rails {
  double friction = 0.3, radius = 20e-3, half_gap = 8e-3, v0 = 0.0, rails = 0.0;

  double slope() const {  // of the line from a rail to the centre, against the vertical
    return std::asin(half_gap / (radius + YarnMaterial{}.radius_m));
  }
  double deceleration() const { return friction * kG / std::cos(slope()); }
  Simulation start() const {
    const double height = (radius + YarnMaterial{}.radius_m) * std::cos(slope());
    Scene scene = yarns_and(ball({0.1, height, 0.0}, radius, 0.01, friction, {v0, 0.0, 0.0}),
                            {straight_yarn({-0.1, 0.0, -half_gap}, {0.4, 0.0, -half_gap}, 5),
                             straight_yarn({-0.1, 0.0, half_gap}, {0.4, 0.0, half_gap}, 5)});
    scene.effects.gravity.emplace();
    scene.effects.colliders->stick_stiffness_n_per_m = 1e3;  // slips after a fraction of what a step slides
    Handle all{AllNodes{}, {}, false};
    if (rails != 0.0) all.velocity_m_per_s = Vec3(rails, 0.0, 0.0);
    scene.handles = {all};
    return Simulation(checked_model(scene));
  }
};

void expect_coulomb(const Rails& rails) {
  Simulation sim = rails.start();
  const double h = 5e-4, sliding = rails.v0 - rails.rails, a = std::copysign(rails.deceleration(), sliding);
  double at_20_ms = 0.0;
  for (int n = 1; n <= 300; ++n) {
    advance(sim, h, tight(1e-7, 1e-9));
    if (n == 40) at_20_ms = the_body(sim).velocity_m_per_s.x();
    if (n == 100) {
      const double measured = (at_20_ms - the_body(sim).velocity_m_per_s.x()) / (60 * h);
      std::printf("friction slows the sliding by %.4f m/s^2, expected %.4f\n", measured, a);
      EXPECT_NEAR(measured, a, 0.02 * std::abs(a) + 1e-6);
    }
  }
  EXPECT_NEAR(the_body(sim).velocity_m_per_s.x(), rails.friction > 0.0 ? rails.rails : rails.v0, 2e-3);
}

TEST(Body, FrictionSlowsItOnRailsAtRestUntilItStops) { expect_coulomb({.v0 = 0.3}); }

TEST(Body, FrictionTakesItAlongOnRailsThatMove) { expect_coulomb({.rails = 0.3}); }

TEST(Body, RidesOnRailsThatMoveWithItWithoutFriction) {
  Simulation sim = Rails{.v0 = 0.3, .rails = 0.3}.start();
  for (int n = 0; n < 100; ++n) {
    advance(sim, 5e-4, tight(1e-7, 1e-9));
    EXPECT_NEAR(the_body(sim).velocity_m_per_s.x(), 0.3, 1e-3);
  }
}

TEST(Body, SlidesForEverWithoutFriction) {
  Simulation sim = Rails{.friction = 0.0, .v0 = 0.3}.start();
  for (int n = 0; n < 100; ++n) advance(sim, 5e-4, tight(1e-7, 1e-9));
  EXPECT_NEAR(the_body(sim).velocity_m_per_s.x(), 0.3, 1e-3);
  EXPECT_FALSE(sim.effect_costs().contains("body_friction"));
}

}  // namespace
}  // namespace slipstitch::testing
