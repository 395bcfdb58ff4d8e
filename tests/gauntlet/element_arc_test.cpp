// SPDX-License-Identifier: MIT
// The step filter and the barrier keep the order of nodes along a yarn whatever step is asked for.
#include <random>

#include "gauntlet/element_fixture.h"
#include "sim/arc_barrier.h"
#include "sim/simulation.h"

namespace slipstitch::testing {
namespace {

constexpr double kKeep = 0.1, kFloor = 0.05;  // of a segment's arc length: of one step, of the barrier
constexpr int kVisits = 8;
constexpr int kStepsAboveRounding = 8;  // each leaves a tenth of the room above a floor

class ElementArc : public Element {};

/// Two yarns of four visits, their segments from a tenth of a millimetre to a metre.
Topology two_yarns() {
  Topology t;
  t.num_nodes = kVisits;
  t.yarn_first = {0, 4, 8};
  for (int i = 0; i < kVisits; ++i) t.visit_node.push_back(i);
  t.visit_slides.assign(kVisits, 1);
  const SegmentKind f = SegmentKind::free, none = SegmentKind::none;
  t.segment_kind = {f, f, f, none, f, f, f, none};
  t.rest_arc = {0.0, 1e-4, 2e-4, 3e-4, 0.0, 1e-3, 2e-3, 1.0};
  return t;
}

VecX start_of(const Topology& t) {
  VecX q = VecX::Zero(t.num_coords());
  for (int i = 0; i < kVisits; ++i) q[t.arc_coord(i)] = t.rest_arc[static_cast<std::size_t>(i)];
  return q;
}

bool in_order(const Topology& t, const VecX& q) {
  for (const int i : {0, 1, 2, 4, 5, 6})
    if (!(q[t.arc_coord(i + 1)] > q[t.arc_coord(i)])) return false;
  return true;
}

VecX random_step(const Topology& t, double size, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  VecX dq = VecX::Zero(t.num_coords());
  for (int i = 0; i < kVisits; ++i) dq[t.arc_coord(i)] = size * normal(random);
  return dq;
}

std::vector<double> step_sizes() {
  std::vector<double> sizes;
  for (int e = -6; e <= 6; ++e) sizes.push_back(std::pow(10.0, e));
  sizes.push_back(std::numeric_limits<double>::max() / 1e10);
  return sizes;
}

TEST_F(ElementArc, FilteredStepKeepsEveryOrderAndATenthOfEverySegment) {
  const Topology t = two_yarns();
  std::mt19937_64 random(5);
  for (const double size : step_sizes())
    for (int k = 0; k < 200; ++k) {
      const VecX q = start_of(t), dq = random_step(t, size, random);
      const double a = order_preserving_step(t, q, dq, kKeep);
      ASSERT_GT(a, 0.0) << size;
      ASSERT_LE(a, 1.0);
      const VecX moved = q + a * dq;
      for (const int i : {0, 1, 2, 4, 5, 6}) {
        const double left = moved[t.arc_coord(i + 1)] - moved[t.arc_coord(i)];
        const double before = q[t.arc_coord(i + 1)] - q[t.arc_coord(i)];
        const double rounding = 4 * kEpsilon * moved.cwiseAbs().maxCoeff();
        EXPECT_GE(left, kKeep * before - rounding) << size;
      }
    }
}

TEST_F(ElementArc, FilterIsAsLongAsTheTightestSegmentAllows) {
  const Topology t = two_yarns();
  for (const double size : step_sizes()) {
    VecX dq = VecX::Zero(t.num_coords());
    dq[t.arc_coord(1)] = size;  // towards the end of a segment of 1e-4
    EXPECT_NEAR(order_preserving_step(t, start_of(t), dq, kKeep) / std::min(1.0, 0.9 * 1e-4 / size), 1.0, 1e-12);
  }
}

// Step after step from where the last one ended: the barrier's floors are of the start and stay.
TEST_F(ElementArc, BarrierHoldsItsFloorsThroughAnyNumberOfStepsOfAnySize) {
  const Topology t = two_yarns();
  for (const double size : step_sizes()) {
    std::mt19937_64 random(11);
    VecX q = start_of(t);
    ArcBarrier barrier;
    barrier.keep(t, q, kFloor, 50.0);
    const VecX way = random_step(t, size, random);  // always the same way, as a force that never yields
    for (int k = 0; k < 100; ++k) {
      const double a = barrier.max_step(q, way, order_preserving_step(t, q, way, kKeep));
      ASSERT_GE(a, 0.0);
      const VecX moved = q + a * way;
      const bool allowed = std::isfinite(barrier.value(moved));
      ASSERT_TRUE(allowed || k >= kStepsAboveRounding) << size << " " << k;
      if (!allowed) break;  // Newton would refuse it
      q = moved;
      ASSERT_TRUE(in_order(t, q)) << size << " " << k;
    }
    for (const int i : {0, 1, 2, 4, 5, 6}) {
      const double rest = start_of(t)[t.arc_coord(i + 1)] - start_of(t)[t.arc_coord(i)];
      EXPECT_GE(q[t.arc_coord(i + 1)] - q[t.arc_coord(i)], kFloor * rest);
    }
  }
}

TEST_F(ElementArc, BarrierIsInfiniteForEveryOrderBrokenByAnUnfilteredStep) {
  const Topology t = two_yarns();
  std::mt19937_64 random(17);
  ArcBarrier barrier;
  barrier.keep(t, start_of(t), kFloor, 50.0);
  int broken = 0;
  for (const double size : step_sizes())
    for (int k = 0; k < 50; ++k) {
      const VecX q = start_of(t) + random_step(t, size, random);
      if (in_order(t, q)) continue;
      ++broken;
      EXPECT_EQ(barrier.value(q), std::numeric_limits<double>::infinity());
    }
  EXPECT_GT(broken, 200);
}

}  // namespace
}  // namespace slipstitch::testing
