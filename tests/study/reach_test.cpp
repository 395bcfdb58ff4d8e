// SPDX-License-Identifier: MIT
#include "study/reach.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/sim_scenes.h"

namespace slipstitch::testing {
namespace {

Reach reach_of(const Scene& scene) {
  Simulation sim(prepare(scene).model);
  return bound_reach(sim, span_of(scene));
}

/// Least distance that any node at any frame is inside of the reach; negative: one was outside.
double least_slack(const Scene& scene, const Reach& reach) {
  double slack = 1e300;
  int nodes = 0;
  RunHooks hooks;
  hooks.on_header = [&](const FrameHeader& header) { nodes = header.topology.num_nodes; };
  hooks.on_frame = [&](const Frame& frame) {
    for (int n = 0; n < nodes; ++n) {
      double inside = -1e300;
      for (const ReachPart& part : reach.parts)
        for (const Vec3& anchor : part.anchors) {
          const Vec3 at = anchor + frame.t * part.velocity + 0.5 * frame.t * frame.t * part.acceleration;
          const double radius = part.radius + frame.t * part.speed + 0.5 * frame.t * frame.t * part.gain;
          inside = std::max(inside, radius - (frame.q.segment<3>(3 * n) - at).norm());
        }
      slack = std::min(slack, inside);
    }
  };
  EXPECT_EQ(run(scene, 1, hooks).status, RunStatus::succeeded);
  return slack;
}

TEST(Reach, HoldsAHangingYarnThatSwings) {
  Scene scene = hanging_yarn();
  scene.duration_s = 0.4;
  const Reach reach = reach_of(scene);
  ASSERT_EQ(reach.no_bound, "");
  ASSERT_EQ(reach.parts.size(), 1U);
  EXPECT_GE(least_slack(scene, reach), 0.0);
  EXPECT_LT(reach.parts[0].radius, 0.4);  // the yarn is 0.2 m long: a bound, and not any number
}

TEST(Reach, HoldsAYarnThatItsWeightStretches) {
  Scene scene = hanging_yarn();
  scene.yarn.stretch_n = 0.05;  // by two fifths
  scene.duration_s = 0.6;
  const Reach reach = reach_of(scene);
  ASSERT_EQ(reach.no_bound, "");
  const double slack = least_slack(scene, reach);
  EXPECT_GE(slack, 0.0);
  EXPECT_GT(reach.parts[0].radius - slack, 1.2 * 0.2);  // farther than the yarn is long
}

TEST(Reach, HoldsAYarnThatComesToRestWithoutInertia) {
  Scene scene = hanging_yarn();
  scene.effects.inertia.reset();
  scene.yarn.stretch_n = 0.05;
  const Reach reach = reach_of(scene);
  ASSERT_EQ(reach.no_bound, "");
  const double slack = least_slack(scene, reach);
  EXPECT_GE(slack, 0.0);
  EXPECT_GT(reach.parts[0].radius - slack, 1.1 * 0.2);  // its weight has stretched it
}

TEST(Reach, HoldsAThrownSoftYarn) {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  scene.yarn.stretch_n = 0.05;
  scene.initial_velocities = {{YarnPoint{0, 4}, Vec3(0.0, 2.0, 0.0)}};
  scene.duration_s = 0.3;
  const Reach reach = reach_of(scene);
  ASSERT_EQ(reach.no_bound, "");
  EXPECT_GE(least_slack(scene, reach), 0.0);
  EXPECT_GT(reach.parts[0].velocity.y(), 0.1);
}

TEST(Reach, HoldsASwatchThatHangs) {
  Scene scene = free_swatch(4, 4);
  scene.effects.gravity.emplace();
  scene.handles = {Handle{Corner::top_left, {}, false}};
  scene.duration_s = 0.1;
  const Reach reach = reach_of(scene);
  ASSERT_EQ(reach.no_bound, "");
  EXPECT_GE(least_slack(scene, reach), 0.0);
}

TEST(Reach, HasNoBoundWhereWorkIsDoneThatNobodyKnows) {
  Scene scene = hanging_yarn();
  scene.handles[0].velocity_m_per_s = Vec3(1.0, 0.0, 0.0);
  EXPECT_NE(reach_of(scene).no_bound, "");
  scene = hanging_yarn();
  scene.effects.air_drag.emplace();
  EXPECT_EQ(reach_of(scene).no_bound, "");  // air only takes energy from what is held
  scene.effects.wind.emplace();
  EXPECT_NE(reach_of(scene).no_bound, "");
  scene = hanging_yarn();
  scene.handles.clear();
  scene.loads = {{YarnPoint{0, 1}, Vec3(1.0, 0.0, 0.0)}};
  EXPECT_NE(reach_of(scene).no_bound, "");
  scene = hanging_yarn();
  scene.effects.inertia.reset();
  EXPECT_EQ(reach_of(scene).no_bound, "");
  scene.handles.clear();
  EXPECT_NE(reach_of(scene).no_bound, "");
}

// A yarn that flies against a held one comes back, and a held one is hit by what falls on it.
TEST(Reach, HasNoBoundWherePartsCanPushEachOther) {
  Scene scene = hanging_yarn();
  BareYarn thrown = scene.yarns[0];
  for (Vec3& point : thrown.points) point += 0.05 * Vec3::UnitZ();
  thrown.velocity_m_per_s = -2.0 * Vec3::UnitZ();
  scene.yarns.push_back(thrown);
  EXPECT_EQ(reach_of(scene).no_bound, "") << "they pass through each other";
  scene.effects.self_collision.emplace();
  EXPECT_NE(reach_of(scene).no_bound, "");
  Simulation sim(prepare(scene).model);
  EXPECT_NE(reach_at_twice_its_length(sim, span_of(scene)).no_bound, "");
}

TEST(Reach, HasNoBoundWhereTheIntegratorMayAddEnergy) {
  Scene scene = hanging_yarn();
  scene.numerics = AccuracyNumerics{1e-3};
  EXPECT_NE(reach_of(scene).no_bound, "");
  for (const Integrator integrator : {Integrator::bdf2, Integrator::linearised_euler}) {
    scene.numerics = FixedNumerics{.integrator = integrator};
    EXPECT_NE(reach_of(scene).no_bound, "");
  }
  scene.effects.inertia.reset();
  EXPECT_EQ(reach_of(scene).no_bound, "");
}

TEST(Reach, TellsBodiesThatStayOutsideFromThoseThatComeNear) {
  Scene scene = hanging_yarn();
  const Reach reach = reach_of(scene);
  const double r = reach.parts[0].radius;
  const RunSpan span{1.0, 0.005};
  const auto ball = [](double x, std::vector<Keyframe> motion = {}) {
    return Collider{Sphere{Vec3(x, 0.0, 0.0), 0.01}, 0.3, std::move(motion)};
  };
  EXPECT_TRUE(stays_out_of_reach(reach, ball(-r - 0.02), span));
  EXPECT_FALSE(stays_out_of_reach(reach, ball(-r), span));
  const std::vector<Keyframe> in_and_out{{0.0}, {0.5, Vec3(1.0, 0.0, 0.0)}, {0.52}};
  EXPECT_FALSE(stays_out_of_reach(reach, ball(-r - 0.9, in_and_out), span));
  EXPECT_TRUE(stays_out_of_reach(reach, ball(-r - 0.9, in_and_out), {0.3, 0.005}));
  const std::vector<Keyframe> flash{{0.5001}, {0.5002, Vec3(1.0, 0.0, 0.0)}, {0.5003}};
  EXPECT_FALSE(stays_out_of_reach(reach, ball(-r - 0.9, flash), span));
}

TEST(Reach, IsOfNoUseBehindABodyThatCanPushTheFabricAway) {
  Scene scene = hanging_yarn();
  CollidersEffect& effect = scene.effects.colliders.emplace();
  const Collider far{Sphere{Vec3(0.0, 5.0, 0.0), 0.01}, 0.3, {}};
  const Collider near{Sphere{Vec3(0.1, -0.1, 0.0), 0.01}, 0.3, {}};
  const auto outside = [&] {
    Simulation sim(prepare(scene).model);
    return colliders_out_of_reach(sim, bound_reach(sim, {0.5, 0.005}), {0.5, 0.005});
  };
  effect.colliders = {near, far};
  EXPECT_EQ(outside(), std::vector<int>{1});  // the near one stands still and adds no energy
  effect.colliders[0].motion = {{0.1, Vec3(0.0, 0.1, 0.0)}};
  EXPECT_TRUE(outside().empty());
  effect.colliders = {near, far};
  scene.handles.clear();
  EXPECT_TRUE(outside().empty());  // the yarn bounces off the near one
  effect.colliders = {far};
  EXPECT_EQ(outside(), std::vector<int>{0});
  effect.colliders[0].dynamic.emplace().mass_kg = 1.0;
  EXPECT_EQ(outside(), std::vector<int>{0});  // it falls with the yarn
  effect.colliders[0].dynamic->velocity_m_per_s = {0.0, -10.0, 0.0};
  EXPECT_TRUE(outside().empty());
  effect.colliders.push_back(Collider{Sphere{Vec3(9.0, 0.0, 0.0), 0.01}, 0.3, {}});
  EXPECT_TRUE(outside().empty());  // the one that comes pushes the yarn
}

TEST(Reach, AtTwiceItsLengthKnowsNoWork) {
  Scene scene = hanging_yarn();
  scene.handles[0].motion = {{0.1, Vec3(0.25, 0.0, 0.0), Vec3::Zero()}};
  scene.effects.air_drag.emplace();
  scene.effects.wind.emplace().velocity_m_per_s = {9.0, 0.0, 0.0};
  const auto reach = [&] {
    Simulation sim(prepare(scene).model);
    return reach_at_twice_its_length(sim, {0.5, 0.005});
  };
  const Reach held = reach();
  ASSERT_EQ(held.no_bound, "");
  scene.handles[0].motion.clear();
  const Reach still = reach();
  EXPECT_NEAR(held.parts[0].radius - still.parts[0].radius, 0.25, 1e-12);
  const std::vector<Vec3>& points = scene.yarns[0].points;
  const double length = (points.back() - points.front()).norm();
  EXPECT_NEAR(still.parts[0].radius, 2.0 * length + scene.yarn.radius_m, 1e-12);
  scene.handles.clear();
  EXPECT_NE(reach().no_bound, "");  // carried by the wind
  scene.effects.wind.reset();
  EXPECT_EQ(reach().no_bound, "");
}

TEST(Reach, GrowsWithTheFallThatAirSlows) {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  scene.effects.air_drag.emplace();
  const Reach reach = reach_of(scene);
  const double r = reach.parts[0].radius + reach.parts[0].speed * 0.5;
  const Vec3 from = reach.parts[0].anchors[0];
  const auto floor = [&](double below) {
    return Collider{Plane{from - Vec3(0.0, below, 0.0), Vec3::UnitY()}, 0.3, {}};
  };
  EXPECT_TRUE(stays_out_of_reach(reach, floor(r + 1.3), {0.5, 0.005}));  // falls 1.23 m
  EXPECT_FALSE(stays_out_of_reach(reach, floor(r + 1.2), {0.5, 0.005}));
  scene.duration_s = 0.4;
  EXPECT_GT(least_slack(scene, reach), 0.0);
}

TEST(Reach, FollowsAFall) {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  const Reach reach = reach_of(scene);
  const Collider floor{Plane{Vec3(0.0, -3.0, 0.0), Vec3::UnitY()}, 0.3, {}};
  EXPECT_TRUE(stays_out_of_reach(reach, floor, {0.5, 0.005}));   // falls 1.2 m
  EXPECT_FALSE(stays_out_of_reach(reach, floor, {1.0, 0.005}));  // 4.9 m
}

}  // namespace
}  // namespace slipstitch::testing
