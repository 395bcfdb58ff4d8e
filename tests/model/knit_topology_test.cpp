// SPDX-License-Identifier: MIT
#include "model/knit_topology.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "knit_helpers.h"
#include "model/drawn_loop.h"

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

// Whether the yarn's visits around `visits` pass the four nodes one after the other, in either direction.
bool passes(const Topology& t, const std::array<int, 2>& visits, std::array<int, 4> nodes) {
  const int step = visits[1] - visits[0];
  if (step != 1 && step != -1) return false;
  for (int k = 0; k < 4; ++k) {
    const int visit = visits[0] + (k - 1) * step;
    if (visit < 0 || visit >= t.num_visits() || t.visit_node[idx(visit)] != nodes[idx(k)]) return false;
  }
  return true;
}

std::vector<int> visits_per_node(const Topology& t) {
  std::vector<int> count(idx(t.num_nodes), 0);
  for (const int node : t.visit_node) ++count[idx(node)];
  return count;
}

void expect_valid(const Knit& knit) {
  const PlacedTopology placed = test::build_drawn(knit);
  const Topology& t = placed.topology;
  const int courses = knit.pattern.courses, wales = knit.pattern.wales, stitches = courses * wales;

  ASSERT_EQ(t.yarn_first, (std::vector<int>{0, t.num_visits()}));
  const int turns = knit.pattern.in_the_round ? 0 : 2 * (courses - 1);
  EXPECT_EQ(t.num_visits(), 8 * stitches + turns + 2);
  EXPECT_EQ(t.num_nodes, 4 * stitches + 2 * (wales + 1) + turns + 2);
  EXPECT_EQ(t.contacts.size(), idx(2 * (courses - 1) * wales + wales - 1));
  ASSERT_EQ(placed.q.size(), t.num_coords());
  EXPECT_TRUE(placed.q.allFinite());

  for (int i = 0; i + 1 < t.num_visits(); ++i) {
    EXPECT_GT(t.rest_arc[idx(i) + 1], t.rest_arc[idx(i)]);
    EXPECT_GT(placed.q[t.arc_coord(i + 1)], placed.q[t.arc_coord(i)]);
    EXPECT_NE(t.segment_kind[idx(i)], SegmentKind::none);
  }
  EXPECT_EQ(t.segment_kind.back(), SegmentKind::none);

  std::vector<int> in_contact(idx(t.num_nodes), 0);
  for (const StitchContact& c : t.contacts) {
    EXPECT_TRUE(passes(t, c.u_visit, {c.q4, c.q0, c.q1, c.q5}));
    EXPECT_TRUE(passes(t, c.v_visit, {c.q2, c.q0, c.q1, c.q3}));
    EXPECT_EQ(c.sign, (c.kind == StitchKind::knit ? 1 : -1) * (c.side == ClaspSide::left ? 1 : -1));
    EXPECT_EQ((std::set<int>{c.q0, c.q1, c.q2, c.q3, c.q4, c.q5}).size(), 6u);
    ++in_contact[idx(c.q0)];
    ++in_contact[idx(c.q1)];
  }
  const std::vector<int> visits = visits_per_node(t);
  for (int n = 0; n < t.num_nodes; ++n) {
    EXPECT_EQ(visits[idx(n)], in_contact[idx(n)] == 1 ? 2 : 1) << "node " << n;
    EXPECT_LE(in_contact[idx(n)], 1);
  }
  for (int i = 0; i < t.num_visits(); ++i) {
    EXPECT_EQ(t.visit_slides[idx(i)], in_contact[idx(t.visit_node[idx(i)])]) << "plain nodes keep their arc length";
  }
}

TEST(KnitTopology, EverySizeIsOneValidYarn) {
  for (int courses = 2; courses <= 6; ++courses) {
    for (int wales = 2; wales <= 6; ++wales) {
      for (const bool in_the_round : {false, true}) {
        SCOPED_TRACE(std::to_string(courses) + " x " + std::to_string(wales) + (in_the_round ? " round" : " flat"));
        expect_valid(test::stockinette(courses, wales, in_the_round));
      }
    }
  }
}

// P1 = (old leg) x (new sinker) and P2 = (new leg) x (old head), on both sides, whatever the yarn's direction.
TEST(KnitTopology, ClaspsAreMirrorImages) {
  const PlacedTopology placed = test::build_drawn(test::stockinette(5, 4));
  const Topology& t = placed.topology;
  for (const Stitch& s : t.stitches) {
    if (s.course == 1) continue;
    const Stitch& below = t.stitches[idx((s.course - 2) * t.num_wales + s.wale - 1)];
    const StitchContact& left = t.contacts[idx(s.base_left)];
    const StitchContact& right = t.contacts[idx(s.base_right)];
    EXPECT_EQ(below.head_left, s.base_left);
    EXPECT_EQ(below.head_right, s.base_right);
    // node: BL1 BL2 HL1 HL2 HR2 HR1 BR2 BR1
    EXPECT_EQ((std::array{left.q0, left.q1, left.q5}), (std::array{s.node[0], s.node[1], s.node[2]}));
    EXPECT_EQ((std::array{right.q0, right.q1, right.q5}), (std::array{s.node[7], s.node[6], s.node[5]}));
    EXPECT_EQ((std::array{left.q2, left.q0, left.q1, left.q3}),
              (std::array{below.node[1], below.node[2], below.node[3], below.node[4]}));
    EXPECT_EQ((std::array{right.q2, right.q0, right.q1, right.q3}),
              (std::array{below.node[6], below.node[5], below.node[4], below.node[3]}));
    EXPECT_EQ(left.sign, 1);
    EXPECT_EQ(right.sign, -1);
    // u on the outer side of the axis, v towards the wale's middle.
    const Vec3 q0 = test::position(placed, left.q0), axis = test::position(placed, left.q1) - q0;
    const auto side = [&](int node) { return axis.cross(test::position(placed, node) - q0).z(); };
    EXPECT_GT(side(left.q4), 0.0);
    EXPECT_GT(side(left.q5), 0.0);
    EXPECT_LT(side(left.q2), 0.0);
    EXPECT_LT(side(left.q3), 0.0);
  }
}

TEST(KnitTopology, AnAsymmetricChartLandsWhereAKnitterReadsIt) {
  const Knit knit = test::knit_of({"PKKKK", "KKKKK", "KKPKK", "KPPKP"});
  const PlacedTopology placed = test::build_drawn(knit);
  const Topology& t = placed.topology;
  ASSERT_EQ(t.stitches.size(), 20u);
  std::set<std::pair<int, int>> purls;
  for (const Stitch& s : t.stitches) {
    Vec3 centre = Vec3::Zero();
    for (const int n : s.node) centre += test::position(placed, n) / 8.0;
    if (s.kind == StitchKind::purl) {
      purls.insert({static_cast<int>(centre.y() / 2.03e-3), static_cast<int>(centre.x() / 2.9e-3)});
    }
  }
  // (row from below, column from the left), both from 0
  EXPECT_EQ(purls, (std::set<std::pair<int, int>>{{0, 1}, {0, 2}, {0, 4}, {1, 2}, {3, 0}}));
  for (const StitchContact& c : t.contacts) {
    if (c.stitch >= 0) {
      EXPECT_EQ(c.kind, t.stitches[idx(c.stitch)].kind);
    }
  }
}

TEST(KnitTopology, FlatCoursesRunToAndFroAndRoundOnesAlwaysToTheLeft) {
  for (const bool in_the_round : {false, true}) {
    const PlacedTopology placed = test::build_drawn(test::stockinette(4, 6, in_the_round));
    const Topology& t = placed.topology;
    std::map<int, int> visit_of;
    for (int i = 0; i < t.num_visits(); ++i) visit_of.try_emplace(t.visit_node[idx(i)], i);
    for (const Stitch& s : t.stitches) {
      const int from = visit_of[s.node[0]], to = visit_of[s.node[7]];
      if (s.course > 1) continue;
      EXPECT_GT(from, to) << "course 1 runs -x";
    }
    const StitchContact& second = t.contacts[idx(t.stitches[6].base_left)];
    EXPECT_EQ(second.u_visit[1] - second.u_visit[0], in_the_round ? -1 : 1);
  }
}

TEST(KnitTopology, SelvedgesTurnThroughTwoPlainNodesOnTheirSide) {
  const PlacedTopology placed = test::build_drawn(test::stockinette(4, 3));
  const Topology& t = placed.topology;
  const auto x_of_visit = [&](int i) { return test::position(placed, t.visit_node[idx(i)]).x(); };
  const int per_course = 8 * 3 + 2;
  for (int course = 1; course <= 3; ++course) {
    const int first = 1 + course * per_course - 2;
    const double edge = course % 2 == 1 ? 0.0 : 3 * 2.9e-3;
    EXPECT_NEAR(x_of_visit(first), edge, 1e-9);
    EXPECT_NEAR(x_of_visit(first + 1), edge, 1e-9);
    EXPECT_EQ(t.visit_slides[idx(first)], 0);
    EXPECT_EQ(t.visit_slides[idx(first + 1)], 0);
  }
  EXPECT_GT(x_of_visit(0), 3 * 2.9e-3) << "the first tail leaves on the right";
  EXPECT_GT(x_of_visit(t.num_visits() - 1), 3 * 2.9e-3) << "course 4 runs +x";
}

TEST(KnitTopology, ATailIsOneStitchLongAndMassAStitchIsTheYarns) {
  Knit knit = test::stockinette(4, 3);
  knit.gauge.yarn_per_stitch_m = 9e-3;
  const PlacedTopology placed = test::build_drawn(knit);
  const Topology& t = placed.topology;
  const double scale = t.density_scale[0];
  EXPECT_NEAR((t.rest_arc[1] - t.rest_arc[0]) * scale, 9e-3, 1e-12);
  EXPECT_NEAR((t.rest_arc[idx(t.num_visits() - 1)] - t.rest_arc[idx(t.num_visits() - 2)]) * scale, 9e-3, 1e-12);
  const Stitch& inner = t.stitches[4];
  const StitchContact& left = t.contacts[idx(inner.base_left)];
  const double pitch = std::fabs(t.rest_arc[idx(left.u_visit[0])] - t.rest_arc[idx(left.u_visit[0] + 8)]);
  EXPECT_NEAR(pitch * scale, 9e-3, 1e-12) << "from one base to the next of the same course";
}

TEST(KnitTopology, WovenInTheYarnBeginsWithASlipKnotAndEndsInTheLastLoop) {
  for (const bool in_the_round : {false, true}) {
    Knit knit = test::stockinette(4, 3, in_the_round);
    const PlacedTopology loose = test::build_drawn(knit);
    knit.ends_woven_in = true;
    const PlacedTopology woven = test::build_drawn(knit);
    const Topology &a = loose.topology, &b = woven.topology;
    EXPECT_EQ(b.num_nodes, a.num_nodes - 2);
    ASSERT_EQ(b.num_visits(), a.num_visits() - 1);
    EXPECT_EQ(b.yarn_first, (std::vector<int>{0, b.num_visits()}));
    EXPECT_EQ(b.visit_node[0], b.stitches[2].node[0]) << "right stitch of course 1, the left end of its base";
    EXPECT_EQ(visits_per_node(b)[idx(b.visit_node[0])], 2);
    EXPECT_TRUE(std::equal(b.visit_node.begin() + 1, b.visit_node.end(), a.visit_node.begin() + 1));
    EXPECT_EQ(woven.q.head(3 * b.num_nodes), loose.q.head(3 * b.num_nodes));
    EXPECT_EQ(b.visit_slides.front(), 0);
    EXPECT_EQ(b.visit_slides.back(), 0) << "the knot";
    EXPECT_EQ(b.visit_slides[b.visit_slides.size() - 2], 1);
    EXPECT_EQ(b.contacts.size(), a.contacts.size());
    for (int i = 0; i + 1 < b.num_visits(); ++i) EXPECT_GT(b.rest_arc[idx(i) + 1], b.rest_arc[idx(i)]);
  }
}

TEST(KnitTopology, PlacementTurnsTheFabric) {
  Knit knit = test::stockinette(3, 3);
  const PlacedTopology plain = test::build_drawn(knit);
  const double right_side = draw_loop(2.9e-3, 2.03e-3, 0.524e-3).z;  // knit clasps lie this much to the front
  EXPECT_GT(right_side, 0.0);
  EXPECT_NEAR(test::position(plain, 0).z(), right_side, 1e-15) << "right side towards +z";
  knit.placement = {{1.0, 2.0, 3.0}, {0.0, 0.0, 2.0}, {0.0, 5.0, 1.0}};
  const PlacedTopology placed = test::build_drawn(knit);
  for (int n = 0; n < plain.topology.num_nodes; ++n) {
    const Vec3 x = test::position(plain, n);  // course -> z, wale -> y, right side -> z cross y = -x
    EXPECT_LT((test::position(placed, n) - Vec3(1.0 - x.z(), 2.0 + x.y(), 3.0 + x.x())).norm(), 1e-12);
  }
}

TEST(KnitTopology, NoiseIsReproducibleAndBounded) {
  Knit knit = test::stockinette(3, 3);
  const PlacedTopology plain = test::build_drawn(knit);
  knit.noise_m = 1e-4;
  knit.noise_seed = 7;
  const PlacedTopology first = test::build_drawn(knit), second = test::build_drawn(knit);
  EXPECT_EQ(first.q, second.q);
  knit.noise_seed = 8;
  EXPECT_NE(test::build_drawn(knit).q, first.q);
  const int positions = 3 * plain.topology.num_nodes, arcs = plain.topology.num_visits();
  const VecX moved = first.q - plain.q;
  EXPECT_LE(moved.head(positions).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_GT(moved.head(positions).cwiseAbs().maxCoeff(), 0.9e-4);
  EXPECT_EQ(moved.tail(arcs).cwiseAbs().maxCoeff(), 0.0);
  // First output of mt19937_64 for seed 7 is 0xc11f6531eb66d9a7, worked out by hand from its definition.
  EXPECT_NEAR(moved[0], 5.08770608305716e-05, 1e-15);
}

TEST(KnitTopology, ATubeHasItsRightSideOutwards) {
  const int wales = 12;
  const PlacedTopology placed = test::build_drawn(test::stockinette(4, wales, true));
  const double radius = wales * 2.9e-3 / (2.0 * kPi);
  for (const Stitch& s : placed.topology.stitches) {
    for (const int n : s.node) {
      const Vec3 x = test::position(placed, n);
      EXPECT_NEAR(std::hypot(x.x(), x.z() + radius), radius, 1e-4);
    }
  }
  const Vec3 tail = test::position(placed, placed.topology.visit_node[0]);
  EXPECT_GT(std::hypot(tail.x(), tail.z() + radius), radius + 7e-3) << "tails point outwards";
}

// Neighbouring heads of the last course hook into each other: u the left one, v the right one.
TEST(KnitTopology, BindOffChainsTheHeadsOfTheLastCourse) {
  const PlacedTopology placed = test::build_drawn(test::knit_of({"KPK", "KKK"}));
  const Topology& t = placed.topology;
  const Stitch* last = &t.stitches[3];
  EXPECT_EQ(last[0].head_left, -1);
  EXPECT_EQ(last[2].head_right, -1);
  for (int w = 0; w < 2; ++w) {
    ASSERT_GE(last[w].head_right, 0);
    EXPECT_EQ(last[w].head_right, last[w + 1].head_left);
    const StitchContact& c = t.contacts[idx(last[w].head_right)];
    EXPECT_EQ(c.stitch, -1);
    EXPECT_EQ(c.kind, last[w].kind);
    EXPECT_EQ((std::array{c.q4, c.q0, c.q1, c.q5}),
              (std::array{last[w].node[6], last[w].node[5], last[w].node[4], last[w].node[3]}));
    EXPECT_EQ((std::array{c.q2, c.q0, c.q1, c.q3}),
              (std::array{last[w + 1].node[1], last[w + 1].node[2], last[w + 1].node[3], last[w + 1].node[4]}));
  }
}

}  // namespace
}  // namespace slipstitch
