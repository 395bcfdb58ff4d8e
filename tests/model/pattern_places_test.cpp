// SPDX-License-Identifier: MIT
#include "model/pattern_places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/bare_yarns.h"
#include "model/model.h"

namespace slipstitch {
namespace {

Topology knit(int courses, int wales, bool in_the_round) {
  Scene scene;
  Issues issues;
  scene.knit.emplace().pattern = pattern_from_preset({"stockinette", courses, wales}, in_the_round, "preset", issues);
  scene.knit->gauge = {2.9e-3, 2.03e-3, {}};
  return compile(scene, nullptr).topology;
}

/// The segment across a stitch's head.
int head_of(const Topology& topology, int course, int wale) {
  const auto stitch = std::find_if(topology.stitches.begin(), topology.stitches.end(),
                                   [&](const Stitch& s) { return s.course == course && s.wale == wale; });
  for (std::size_t v = 0; v + 1 < topology.visit_node.size(); ++v) {
    const int n0 = topology.visit_node[v], n1 = topology.visit_node[v + 1];
    if (std::minmax(n0, n1) == std::minmax(stitch->node[3], stitch->node[4])) return static_cast<int>(v);
  }
  ADD_FAILURE() << "no head of course " << course << ", wale " << wale;
  return 0;
}

// A head has nodes of its own course and of the base above it.
TEST(PatternPlaces, CountsCoursesAndWalesBetweenStitches) {
  const Topology flat = knit(12, 10, false);
  const PatternPlaces places(flat);
  const auto near = [&](int course, int wale, int to_course, int to_wale) {
    return places.near_in_pattern(head_of(flat, course, wale), head_of(flat, to_course, to_wale), 3);
  };
  EXPECT_TRUE(near(5, 5, 5, 8));
  EXPECT_FALSE(near(5, 5, 5, 9));
  EXPECT_TRUE(near(2, 5, 6, 5));
  EXPECT_FALSE(near(2, 5, 7, 5));
  EXPECT_FALSE(near(5, 1, 5, 10));
}

TEST(PatternPlaces, GoesAroundATube) {
  const Topology tube = knit(12, 10, true);
  const PatternPlaces places(tube);
  const auto near = [&](int wale, int to_wale) {
    return places.near_in_pattern(head_of(tube, 5, wale), head_of(tube, 5, to_wale), 3);
  };
  EXPECT_TRUE(near(1, 10));
  EXPECT_TRUE(near(2, 9));
  EXPECT_FALSE(near(2, 8));
  EXPECT_FALSE(near(3, 8));
}

TEST(PatternPlaces, PutsTurnsAndTailsBesideTheirStitches) {
  const Topology flat = knit(12, 10, false);
  const PatternPlaces places(flat);
  EXPECT_TRUE(places.near_in_pattern(0, head_of(flat, 1, 10), 0));
  EXPECT_TRUE(places.near_in_pattern(flat.num_visits() - 2, head_of(flat, 12, 10), 3));
  EXPECT_FALSE(places.near_in_pattern(0, flat.num_visits() - 2, 3));
}

// Points 1 mm apart; the yarns cross at the point 3 of both.
TEST(PatternPlaces, MeasuresYarnBetweenSegmentsAndOverACrossing) {
  Scene scene;
  for (int y = 0; y < 3; ++y) {
    BareYarn yarn;
    for (int i = 0; i < 8; ++i)
      yarn.points.push_back(y == 1 ? Vec3(3e-3, 1e-3 * (i - 3), 0.0) : Vec3(1e-3 * i, 0.0, -1e-3 * y));
    scene.yarns.push_back(yarn);
  }
  scene.crossings = {{0, 3, 1, 3}};
  const Topology topology = build_bare_yarns(scene).topology;
  const PatternPlaces places(topology);
  const auto segment = [&](int yarn, int i) { return topology.yarn_first[static_cast<std::size_t>(yarn)] + i; };
  EXPECT_TRUE(places.near_on_yarn(segment(0, 1), segment(0, 4), 2.1e-3));
  EXPECT_FALSE(places.near_on_yarn(segment(0, 1), segment(0, 4), 1.9e-3));
  EXPECT_FALSE(places.near_on_yarn(segment(0, 4), segment(0, 1), 1.9e-3));
  EXPECT_TRUE(places.near_on_yarn(segment(0, 1), segment(1, 4), 2.1e-3));
  EXPECT_FALSE(places.near_on_yarn(segment(0, 1), segment(1, 4), 1.9e-3));
  EXPECT_FALSE(places.near_on_yarn(segment(0, 3), segment(2, 3), 1.0));
  EXPECT_FALSE(places.near_in_pattern(segment(0, 1), segment(0, 1), 3));
}

}  // namespace
}  // namespace slipstitch
