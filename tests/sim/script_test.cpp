// SPDX-License-Identifier: MIT
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

/// Positions of nodes 0 and 1, held together, at time t.
std::pair<Vec3, Vec3> scripted(const std::vector<Keyframe>& motion, double t) {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  Model model = compile(scene, nullptr);
  model.handles = {{{0, 1}, motion, false}};
  VecX q = model.start_q;
  apply_scripts(model, t, q);
  EXPECT_EQ(q.tail(q.size() - 6), model.start_q.tail(q.size() - 6));
  return {q.segment<3>(0), q.segment<3>(3)};
}

TEST(Script, TranslatesLinearlyBetweenKeyframes) {
  const std::vector<Keyframe> motion = {{0.5, {1.0, 0.0, 0.0}, Vec3::Zero()}, {1.0, {1.0, 2.0, 0.0}, Vec3::Zero()}};
  const Vec3 start(0.05, 0.0, 0.0);
  const auto at = [&](double t) { return Vec3(scripted(motion, t).second - start); };
  EXPECT_LT((at(0.0) - Vec3::Zero()).norm(), 1e-15);
  EXPECT_LT((at(0.25) - Vec3(0.5, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((at(0.5) - Vec3(1.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((at(0.75) - Vec3(1.0, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((at(1.0) - Vec3(1.0, 2.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((at(7.0) - Vec3(1.0, 2.0, 0.0)).norm(), 1e-15);
}

TEST(Script, TurnsAboutTheStartCentroidThenTranslates) {
  const std::vector<Keyframe> motion = {{1.0, {0.0, 0.0, 0.3}, {0.0, 0.0, kPi}}};
  const auto [first, second] = scripted(motion, 0.5);  // a quarter turn about (0.025, 0, 0)
  EXPECT_LT((first - Vec3(0.025, -0.025, 0.15)).norm(), 1e-15);
  EXPECT_LT((second - Vec3(0.025, 0.025, 0.15)).norm(), 1e-15);
}

TEST(Script, LeavesAPinWhereItStarted) {
  const auto [first, second] = scripted({}, 3.0);
  EXPECT_EQ(first, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(second, Vec3(0.05, 0.0, 0.0));
}

TEST(Script, AVelocityIsAMotionWithoutEnd) {
  Scene scene = hanging_yarn();
  scene.handles[0].velocity_m_per_s = Vec3(0.5, -1.0, 0.25);
  const Model model = compile(scene, nullptr);
  for (const double t : {0.0, 0.5, 40.0}) {
    VecX q = model.start_q;
    apply_scripts(model, t, q);
    EXPECT_EQ(Vec3(q.head<3>()), Vec3(t * Vec3(0.5, -1.0, 0.25)));
  }
}

TEST(Script, IsFollowedByTheSimulation) {
  Scene scene = hanging_yarn();
  scene.handles[0].motion = {{1.0, {0.0, 0.1, 0.0}, Vec3::Zero()}};
  Simulation sim(compile(scene, nullptr));
  for (int n = 1; n <= 10; ++n) {
    ASSERT_TRUE(sim.step(0.01, FixedNumerics{}, {}).accepted);
    EXPECT_NEAR(sim.state().q[1], 0.001 * n, 1e-15);
  }
}

TEST(OrderPreservingStep, StopsWhereASegmentKeepsItsShare) {
  const Model model = compile(crossed_yarns(), nullptr);
  const Topology& topo = model.topology;
  const VecX& q = model.start_q;
  VecX dq = VecX::Zero(q.size());
  EXPECT_EQ(order_preserving_step(topo, q, dq, 0.1), 1.0);
  dq[topo.arc_coord(2)] = 0.04;  // of the 0.05 ahead of it
  EXPECT_EQ(order_preserving_step(topo, q, dq, 0.1), 1.0);
  dq[topo.arc_coord(2)] = 0.09;
  EXPECT_NEAR(order_preserving_step(topo, q, dq, 0.1), 0.5, 1e-12);
  dq[topo.arc_coord(2)] = -0.18;
  EXPECT_NEAR(order_preserving_step(topo, q, dq, 0.1), 0.25, 1e-12);
  dq.tail(topo.num_visits()).setConstant(-5.0);  // the whole yarn through its contacts: no segment changes
  EXPECT_EQ(order_preserving_step(topo, q, dq, 0.1), 1.0);
  dq.setZero();
  dq[topo.arc_coord(4)] = 1.0;  // last of yarn 0 and first of yarn 1 are no neighbours
  dq[topo.arc_coord(5)] = -1.0;
  EXPECT_EQ(order_preserving_step(topo, q, dq, 0.1), 1.0);
}

TEST(OrderPreservingStep, KeepsArcLengthsInOrderUnderAHardPull) {
  Scene scene = crossed_yarns();
  scene.handles = {held(1, 0), held(1, -1), held(0, -1)};
  scene.handles.back().motion = {{0.05, {0.3, 0.0, 0.0}, Vec3::Zero()}};
  Simulation sim(compile(scene, nullptr));
  const Topology& topo = sim.model().topology;
  for (int n = 0; n < 50; ++n) {
    sim.step(1e-3, FixedNumerics{}, {});
    for (int i = 0; i + 1 < topo.num_visits(); ++i) {
      if (topo.segment_kind[static_cast<std::size_t>(i)] == SegmentKind::none) continue;
      ASSERT_GT(sim.state().q[topo.arc_coord(i + 1)], sim.state().q[topo.arc_coord(i)]) << n;
    }
  }
}

}  // namespace
}  // namespace slipstitch::testing
