// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <utility>

#include "knit_helpers.h"
#include "model/knit_repeat.h"

namespace slipstitch {
namespace {

struct Case {
  std::vector<std::string> chart;
  int courses, wales;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{{"KK", "KK"}, 1, 1},
                                     {{"PPPP", "KKKK", "PPPP", "KKKK"}, 2, 1},
                                     {{"KKPPKKPP", "KKPPKKPP"}, 1, 4},
                                     {{"PKPK", "KPKP"}, 2, 2},
                                     {{"KPKKP", "KKPKK", "PKKKK", "KKKPP"}, 4, 5}};
  return all;
}

PeriodicPatch patch_of(const Case& c, int extra_nodes = 0) {
  const Knit knit = test::knit_of(c.chart);
  return build_repeat(knit.pattern, drawn_cell(knit.pattern, knit.gauge, YarnMaterial{}, extra_nodes));
}

/// With and without nodes on free yarn.
std::vector<std::pair<Case, int>> refined_cases() {
  std::vector<std::pair<Case, int>> all;
  for (const Case& c : cases())
    for (const int extra : {0, 1, 3}) all.emplace_back(c, extra);
  return all;
}

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

TEST(Repeat, OwnsFourNodesEightVisitsAndTwoContactsAStitch) {
  for (const Case& c : cases()) {
    const PeriodicPatch patch = patch_of(c);
    const Topology& topology = patch.placed.topology;
    EXPECT_EQ(patch.courses, c.courses);
    EXPECT_EQ(patch.wales, c.wales);
    const int stitches = c.courses * c.wales;
    int own_nodes = 0, own_visits = 0;
    for (int n = 0; n < topology.num_nodes; ++n) own_nodes += patch.node_master[idx(n)] == n ? 1 : 0;
    for (int i = 0; i < topology.num_visits(); ++i) own_visits += topology.owned(i) ? 1 : 0;
    EXPECT_EQ(own_nodes, 4 * stitches);
    EXPECT_EQ(own_visits, 8 * stitches);
    EXPECT_EQ(topology.contacts.size(), idx(2 * stitches));
    EXPECT_EQ(topology.num_yarns(), c.courses + 1);
  }
}

TEST(Repeat, EveryStencilOfAnOwnedElementIsThere) {
  for (const Case& c : cases()) {
    const PeriodicPatch patch = patch_of(c);
    const Topology& topology = patch.placed.topology;
    for (int y = 0; y < topology.num_yarns(); ++y) {
      EXPECT_FALSE(topology.owned(topology.yarn_first[idx(y)])) << "a triple needs a visit before it";
      EXPECT_FALSE(topology.owned(topology.yarn_first[idx(y) + 1] - 1)) << "and one behind it";
    }
    for (const StitchContact& contact : topology.contacts) {
      for (const int node : {contact.q0, contact.q1, contact.q2, contact.q3, contact.q4, contact.q5}) {
        EXPECT_GE(node, 0);
      }
      EXPECT_LT(contact.q0, 4 * c.courses * c.wales) << "axis nodes are the repeat's own";
      EXPECT_TRUE(contact.owned);
    }
    int contact_segments = 0;
    for (int i = 0; i < topology.num_visits(); ++i) {
      if (topology.owned(i) && topology.segment_kind[idx(i)] == SegmentKind::contact) ++contact_segments;
    }
    EXPECT_EQ(contact_segments, 4 * c.courses * c.wales);
  }
}

TEST(Repeat, ImagesFollowTheirMasters) {
  for (const auto& [c, extra] : refined_cases()) {
    const PeriodicPatch patch = patch_of(c, extra);
    const Topology& topology = patch.placed.topology;
    for (int n = 0; n < topology.num_nodes; ++n) {
      const int master = patch.node_master[idx(n)];
      ASSERT_EQ(patch.node_master[idx(master)], master);
      const Vec3 image = test::position(patch.placed, master) + patch.node_shift[idx(n)][0] * patch.period_course +
                         patch.node_shift[idx(n)][1] * patch.period_wale;
      EXPECT_LT((image - test::position(patch.placed, n)).norm(), 1e-15);
    }
    for (int i = 0; i < topology.num_visits(); ++i) {
      const int master = patch.visit_master[idx(i)];
      ASSERT_TRUE(topology.owned(master));
      EXPECT_EQ(patch.node_master[idx(topology.visit_node[idx(i)])],
                patch.node_master[idx(topology.visit_node[idx(master)])]);
      EXPECT_NEAR(topology.rest_arc[idx(i)], topology.rest_arc[idx(master)] + patch.visit_arc_offset[idx(i)], 1e-15);
      EXPECT_TRUE(!topology.owned(i) || master == i);
    }
  }
}

TEST(Repeat, SegmentsOfTheDrawnRepeatAreAtRest) {
  for (const auto& [c, extra] : refined_cases()) {
    const PeriodicPatch patch = patch_of(c, extra);
    const Topology& topology = patch.placed.topology;
    for (int i = 0; i < topology.num_visits(); ++i) {
      if (topology.segment_kind[idx(i)] == SegmentKind::none) continue;
      const double length = (test::position(patch.placed, topology.visit_node[idx(i) + 1]) -
                             test::position(patch.placed, topology.visit_node[idx(i)]))
                                .norm();
      EXPECT_NEAR(length, topology.rest_arc[idx(i) + 1] - topology.rest_arc[idx(i)], 1e-12);
    }
  }
}

TEST(Repeat, ReadsBackTheCellItWasBuiltFrom) {
  for (const auto& [c, extra] : refined_cases()) {
    const Knit knit = test::knit_of(c.chart);
    RestCell cell = drawn_cell(knit.pattern, knit.gauge, YarnMaterial{}, extra);
    for (std::size_t i = 0; i < cell.start_length.size(); ++i) {  // slide some yarn through every node of a course
      cell.start_length[i] += (i % 2 == 0 ? 1e-5 : -1e-5);
    }
    const PeriodicPatch patch = build_repeat(knit.pattern, cell);
    const RestCell back = cell_from_patch(patch, patch.placed.q, patch.period_course, patch.period_wale);
    ASSERT_EQ(back.node_position.size(), cell.node_position.size());
    for (std::size_t n = 1; n < cell.node_position.size(); ++n) {
      const Vec3 before = cell.node_position[n] - cell.node_position[0];
      const Vec3 after = back.node_position[n] - back.node_position[0];
      EXPECT_LT((before - after).norm(), 1e-15);
    }
    for (std::size_t i = 0; i < cell.start_length.size(); ++i) {
      EXPECT_NEAR(back.start_length[i], cell.start_length[i], 1e-15);
      EXPECT_NEAR(back.rest_length[i], cell.rest_length[i], 1e-15);
    }
    EXPECT_EQ(back.extra_nodes, extra);
    ASSERT_EQ(back.between.size(), cell.between.size());
    for (int n = 0; n < static_cast<int>(cell.between.size()); ++n) {
      EXPECT_LT((back.between[idx(n)] - back.node_position[0] - cell.between[idx(n)] + cell.node_position[0]).norm(), 1e-15);
    }
    EXPECT_EQ(back.density_scale, cell.density_scale);
  }
}

TEST(Repeat, ATurnedAndShiftedRepeatIsReadBackInItsStandardPlace) {
  const Knit knit = test::knit_of({"PKPK", "KPKP"});
  const RestCell cell = drawn_cell(knit.pattern, knit.gauge, YarnMaterial{});
  const PeriodicPatch patch = build_repeat(knit.pattern, cell);
  const Mat3 turn = Eigen::AngleAxisd(0.3, Vec3::UnitZ()).toRotationMatrix();
  VecX q = patch.placed.q;
  for (int n = 0; n < patch.placed.topology.num_nodes; ++n) {
    q.segment<3>(3 * n) = turn * patch.placed.q.segment<3>(3 * n) + Vec3(0.01, -0.02, 0.03);
  }
  const RestCell back = cell_from_patch(patch, q, turn * patch.period_course, turn * patch.period_wale);
  EXPECT_LT((back.period_course - cell.period_course).norm(), 1e-15);
  EXPECT_LT((back.period_wale - cell.period_wale).norm(), 1e-15);
  for (std::size_t n = 0; n < cell.node_position.size(); ++n) {
    EXPECT_LT((back.node_position[n] - cell.node_position[n]).norm(), 1e-15);
  }
}

// Inside, the tiled knit has the same wraps and segments as the endless one.
TEST(Repeat, OwnsTheExtraNodesOfItsFreeSegments) {
  for (const Case& c : cases()) {
    const PeriodicPatch patch = patch_of(c, 3);
    const Topology& topology = patch.placed.topology;
    const int stitches = c.courses * c.wales;
    EXPECT_EQ(patch.num_masters, (4 + 4 * 3) * stitches);
    int own_visits = 0;
    for (int n = 0; n < patch.num_masters; ++n) {
      EXPECT_EQ(patch.node_master[idx(n)], n);
      EXPECT_EQ(patch.node_shift[idx(n)], (std::array<int, 2>{0, 0}));
    }
    for (int i = 0; i < topology.num_visits(); ++i) own_visits += topology.owned(i) ? 1 : 0;
    EXPECT_EQ(own_visits, (8 + 4 * 3) * stitches);
  }
}

TEST(Repeat, TilingReproducesThePeriodicGeometry) {
  for (const Case& c : cases()) {
    Knit knit = test::knit_of(c.chart);
    const RestCell cell = drawn_cell(knit.pattern, knit.gauge, YarnMaterial{});
    const PeriodicPatch patch = build_repeat(knit.pattern, cell);
    Pattern& p = knit.pattern;  // three repeats each way
    const Pattern small = p;
    p.courses = 3 * c.courses;
    p.wales = 3 * c.wales;
    p.cells.clear();
    for (int r = 0; r < p.courses; ++r) {
      for (int w = 0; w < p.wales; ++w) p.cells.push_back(small.at(r % c.courses + 1, w % c.wales + 1));
    }
    const PlacedTopology knitted = build_knit(knit, cell);
    for (const StitchContact& own : patch.placed.topology.contacts) {
      const Stitch& s = patch.placed.topology.stitches[idx(own.stitch)];
      const int course = s.course + c.courses, wale = s.wale + c.wales;
      const Stitch& tiled = knitted.topology.stitches[idx((course - 1) * p.wales + wale - 1)];
      const int index = own.side == ClaspSide::left ? tiled.base_left : tiled.base_right;
      const StitchContact& image = knitted.topology.contacts[idx(index)];
      EXPECT_EQ(image.sign, own.sign);
      const std::array<int, 6> a{own.q0, own.q1, own.q2, own.q3, own.q4, own.q5};
      const std::array<int, 6> b{image.q0, image.q1, image.q2, image.q3, image.q4, image.q5};
      for (std::size_t k = 0; k < 6; ++k) {
        const Vec3 shift = test::position(knitted, b[k]) - test::position(patch.placed, a[k]);
        EXPECT_LT((shift - patch.period_course - patch.period_wale).norm(), 1e-12);
      }
      for (const auto& [mine, theirs] :
           {std::pair{own.u_visit, image.u_visit}, std::pair{own.v_visit, image.v_visit}}) {
        const auto gap = [](const Topology& t, const std::array<int, 2>& visits) {
          return std::fabs(t.rest_arc[idx(visits[1])] - t.rest_arc[idx(visits[0])]);
        };
        EXPECT_NEAR(gap(patch.placed.topology, mine), gap(knitted.topology, theirs), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace slipstitch
