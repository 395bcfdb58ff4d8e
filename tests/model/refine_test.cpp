// SPDX-License-Identifier: MIT
#include "model/refine.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "knit_helpers.h"
#include "model/model.h"
#include "model/pattern_places.h"

namespace slipstitch {
namespace {

constexpr int kExtra = 3;

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

std::vector<Knit> knits() {
  Knit woven_in = test::stockinette(4, 5);
  woven_in.ends_woven_in = true;
  return {test::knit_of({"KPKP", "KKPP", "PKPK"}), test::stockinette(4, 5), woven_in, test::stockinette(3, 6, true)};
}

PlacedTopology refined(Knit knit) {
  knit.refine = kExtra;
  return test::build_drawn(knit);
}

int count(const Topology& topology, SegmentKind kind) {
  return static_cast<int>(std::count(topology.segment_kind.begin(), topology.segment_kind.end(), kind));
}

TEST(Refine, DividesFreeSegmentsOnly) {
  for (const Knit& knit : knits()) {
    const Topology coarse = test::build_drawn(knit).topology, fine = refined(knit).topology;
    EXPECT_EQ(count(fine, SegmentKind::contact), count(coarse, SegmentKind::contact));
    EXPECT_EQ(count(fine, SegmentKind::free), (kExtra + 1) * count(coarse, SegmentKind::free));
    EXPECT_EQ(fine.num_nodes, coarse.num_nodes + kExtra * count(coarse, SegmentKind::free));
    EXPECT_EQ(fine.rest_arc.back(), coarse.rest_arc.back());
    for (int i = 0; i + 1 < fine.num_visits(); ++i) EXPECT_GT(fine.rest_arc[idx(i) + 1], fine.rest_arc[idx(i)]);
  }
}

TEST(Refine, LeavesContactsAndTheirOuterNodes) {
  for (const Knit& knit : knits()) {
    const Topology coarse = test::build_drawn(knit).topology, fine = refined(knit).topology;
    ASSERT_EQ(fine.contacts.size(), coarse.contacts.size());
    for (std::size_t c = 0; c < fine.contacts.size(); ++c) {
      const StitchContact &a = coarse.contacts[c], &b = fine.contacts[c];
      EXPECT_EQ((std::array{a.q0, a.q1, a.q2, a.q3, a.q4, a.q5}), (std::array{b.q0, b.q1, b.q2, b.q3, b.q4, b.q5}));
      for (int end : {0, 1}) {
        EXPECT_EQ(fine.visit_node[idx(b.u_visit[idx(end)])], coarse.visit_node[idx(a.u_visit[idx(end)])]);
        EXPECT_EQ(fine.visit_node[idx(b.v_visit[idx(end)])], coarse.visit_node[idx(a.v_visit[idx(end)])]);
      }
    }
  }
}

TEST(Refine, ExtraNodesLieOnTheYarnAndKeepTheirArcLength) {
  for (const Knit& knit : knits()) {
    const PlacedTopology placed = refined(knit);
    const Topology& topology = placed.topology;
    int extra = 0;
    for (int i = 0; i < topology.num_visits(); ++i) {
      if (!topology.extra(i)) continue;
      ++extra;
      EXPECT_EQ(topology.visit_slides[idx(i)], 0);
      const Vec3 before = test::position(placed, topology.visit_node[idx(i) - 1]),
                 here = test::position(placed, topology.visit_node[idx(i)]),
                 behind = test::position(placed, topology.visit_node[idx(i) + 1]);
      // In the round the drawn lines are wound up.
      if (!knit.pattern.in_the_round) {
        EXPECT_LT(((before + behind) / 2 - here).norm(), 1e-12);
      }
      EXPECT_NEAR(placed.q[topology.arc_coord(i)],
                  (placed.q[topology.arc_coord(i - 1)] + placed.q[topology.arc_coord(i + 1)]) / 2, 1e-15);
    }
    EXPECT_EQ(extra, kExtra * count(test::build_drawn(knit).topology, SegmentKind::free));
  }
}

TEST(Refine, IsKnownOfAKnitBehindABareYarn) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()};
  scene.knit = test::stockinette(4, 5);
  scene.knit->refine = kExtra;
  const Topology topology = compile(scene, nullptr).topology, alone = refined(test::stockinette(4, 5)).topology;
  ASSERT_EQ(topology.visit_extra.size(), topology.visit_node.size());
  for (int i = 0; i < topology.num_visits(); ++i) EXPECT_EQ(topology.extra(i), i >= 3 && alone.extra(i - 3));
}

TEST(Refine, ATubeStaysRound) {
  const Topology topology = refined(test::stockinette(4, 12, true)).topology;
  const PatternPlaces places(topology);
  int first = -1, last = -1;  // segments of one course at wales 1 and 12
  for (int i = 0; i < topology.num_visits(); ++i) {
    if (topology.visit_node[idx(i)] == topology.stitches[12].node[0]) first = i;
    if (topology.visit_node[idx(i)] == topology.stitches[23].node[7]) last = i;
  }
  ASSERT_GE(first, 0);
  ASSERT_GE(last, 0);
  EXPECT_TRUE(places.near_in_pattern(first, last, 1));
}

}  // namespace
}  // namespace slipstitch
