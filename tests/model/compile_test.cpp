// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "knit_helpers.h"
#include "model/model.h"
#include "model/select.h"

namespace slipstitch {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

BareYarn line(const Vec3& from, const Vec3& step, int points) {
  BareYarn yarn;
  for (int i = 0; i < points; ++i) yarn.points.push_back(from + i * step);
  return yarn;
}

Scene crossing_scene() {
  Scene scene;
  scene.yarns = {line({0, 0, 0}, {0.01, 0, 0}, 5), line({0.02, -0.02, 0.001}, {0, 0.01, 0}, 5)};
  scene.crossings = {{1, 2, 0, 2}};
  scene.guides = {{0, 1}};
  return scene;
}

TEST(Compile, ACrossingSharesOneNodeAndBothYarnsSlideThere) {
  const Scene scene = crossing_scene();
  ASSERT_TRUE(check(scene).empty());
  const Model model = compile(scene, nullptr);
  const Topology& t = model.topology;
  EXPECT_EQ(t.num_nodes, 9);
  EXPECT_EQ(t.num_visits(), 10);
  EXPECT_EQ(t.visit_node[2], t.visit_node[7]);
  EXPECT_LT((model.start_q.segment<3>(3 * t.visit_node[2]) - scene.yarns[1].points[2]).norm(), 1e-15) << "point a's";
  EXPECT_EQ(t.visit_slides, (std::vector<std::uint8_t>{0, 1, 1, 0, 0, 0, 0, 1, 0, 0}));
  EXPECT_NEAR(t.rest_arc[2] - t.rest_arc[1], std::hypot(0.01, 0.001), 1e-15) << "measured after the move";
  EXPECT_EQ(t.segment_kind[4], SegmentKind::none);
  EXPECT_EQ(t.density_scale, (std::vector<double>{1.0, 1.0}));
}

TEST(Compile, AGuideHoldsThePlaceAndLetsTheYarnSlide) {
  const Model model = compile(crossing_scene(), nullptr);
  ASSERT_EQ(model.handles.size(), 1u);
  EXPECT_EQ(model.handles[0].nodes, (std::vector<int>{1}));
  EXPECT_TRUE(model.handles[0].motion.empty());
  EXPECT_FALSE(model.handles[0].fix_arc_length);
}

TEST(Compile, DynamicSpheresAreNodesBehindAllYarnAndNoSelectorMeansThem) {
  Scene scene = crossing_scene();
  scene.effects.inertia.emplace();
  scene.effects.colliders.emplace().colliders = {{Plane{}, 0.3, {}},
                                                 {Sphere{{0, 0, 1}, 0.1}, 0.2, {}, DynamicBody{0.5, {1, 2, 3}}},
                                                 {Sphere{{0, 0, 2}, 0.3}, 0.1, {}},
                                                 {Sphere{{0, 0, 3}, 0.4}, 0.0, {}, DynamicBody{0.7}}};
  scene.loads = {{AllNodes{}, {0, -9, 0}}};
  scene.initial_velocities = {{AllNodes{}, {0, 1, 0}}};
  ASSERT_TRUE(check(scene).empty());
  const Model plain = compile(crossing_scene(), nullptr), model = compile(scene, nullptr);
  const Topology& t = model.topology;
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(t.num_bodies, 2);
  EXPECT_EQ(t.num_yarn_nodes(), 9);
  EXPECT_EQ(model.bodies[1].collider, 3);
  EXPECT_EQ(model.bodies[1].node, 10);
  EXPECT_EQ(model.bodies[0].mass_kg, 0.5);
  EXPECT_EQ(model.bodies[0].radius_m, 0.1);
  EXPECT_EQ(model.bodies[0].friction, 0.2);
  EXPECT_EQ(model.start_q.segment<3>(3 * 10), Vec3(0, 0, 3));
  EXPECT_EQ(model.start_v.segment<3>(3 * 9), Vec3(1, 2, 3));
  EXPECT_EQ(model.start_v.segment<3>(3 * 8), Vec3(0, 1, 0));
  EXPECT_EQ(model.start_q.head(27), plain.start_q.head(27));
  EXPECT_EQ(model.start_q.tail(10), plain.start_q.tail(10));
  EXPECT_EQ(model.load_nodes.size(), 9u);
  EXPECT_EQ(select_nodes(AllNodes{}, t), model.load_nodes);
}

TEST(Compile, BareYarnsKeepGivenArcLengthsAndPrestretch) {
  Scene scene;
  scene.yarns = {line({0, 0, 0}, {0.01, 0, 0}, 3), line({0, 1, 0}, {0.01, 0, 0}, 3)};
  scene.yarns[0].prestretch = 1.25;
  scene.yarns[1].arc_lengths_m = {0.5, 0.6, 0.9};
  const Model model = compile(scene, nullptr);
  EXPECT_NEAR(rest_length(model.topology, 0), 0.008, 1e-15);
  EXPECT_EQ(model.topology.rest_arc[3], 0.5);
  EXPECT_NEAR(rest_length(model.topology, 4), 0.3, 1e-15);
  EXPECT_EQ(model.start_q[model.topology.arc_coord(5)], 0.9);
}

TEST(Compile, KnitComesBehindTheBareYarns) {
  Scene scene = crossing_scene();
  scene.knit = test::stockinette(3, 4);
  const Model model = compile(scene, nullptr);
  const Topology& t = model.topology;
  const PlacedTopology alone = test::build_drawn(*scene.knit);
  EXPECT_EQ(t.yarn_first, (std::vector<int>{0, 5, 10, 10 + alone.topology.num_visits()}));
  EXPECT_EQ(t.num_nodes, 9 + alone.topology.num_nodes);
  ASSERT_EQ(t.contacts.size(), alone.topology.contacts.size());
  for (std::size_t k = 0; k < t.contacts.size(); ++k) {
    const StitchContact &a = t.contacts[k], &b = alone.topology.contacts[k];
    EXPECT_EQ((std::array{a.q0, a.q1, a.q2, a.q3, a.q4, a.q5}),
              (std::array{b.q0 + 9, b.q1 + 9, b.q2 + 9, b.q3 + 9, b.q4 + 9, b.q5 + 9}));
    EXPECT_EQ(a.u_visit[0], b.u_visit[0] + 10);
    EXPECT_EQ(t.visit_node[idx(a.u_visit[0])], a.q0);
    EXPECT_EQ(t.visit_node[idx(a.v_visit[1])], a.q1);
  }
  EXPECT_EQ(t.num_courses, 3);
  EXPECT_EQ(t.num_wales, 4);
  for (int n = 0; n < alone.topology.num_nodes; ++n) {
    EXPECT_EQ(model.start_q.segment<3>(t.x_coord(n + 9)), alone.q.segment<3>(3 * n));
  }
  for (int i = 0; i < alone.topology.num_visits(); ++i) {
    EXPECT_EQ(model.start_q[t.arc_coord(i + 10)], alone.q[alone.topology.arc_coord(i)]);
  }
}

TEST(Compile, LinearDensityKeepsTheMassOfAStitch) {
  Scene scene;
  scene.knit = test::stockinette(3, 4);
  scene.knit->gauge.yarn_per_stitch_m = 10e-3;
  const Model model = compile(scene, nullptr);
  const StitchContact& c = model.topology.contacts[2];  // wale 2 of course 2
  const double pitch =
      std::fabs(model.topology.rest_arc[idx(c.u_visit[0])] - model.topology.rest_arc[idx(c.u_visit[0] + 8)]);
  EXPECT_NEAR(linear_density(model, 0) * pitch, 0.077e-3 * 10e-3, 1e-15);
}

std::set<int> stitch_nodes(const Topology& t, int course, int wale) {
  const Stitch& s = t.stitches[idx((course - 1) * t.num_wales + wale - 1)];
  return {s.node.begin(), s.node.end()};
}

std::set<int> selected(const Selector& where, const Topology& t) {
  const std::vector<int> nodes = select_nodes(where, t);
  EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  return {nodes.begin(), nodes.end()};
}

TEST(Select, CornersEdgesRangesAndPoints) {
  const PlacedTopology placed = test::build_drawn(test::stockinette(4, 5));
  const Topology& t = placed.topology;
  EXPECT_EQ(selected(Corner::bottom_left, t), stitch_nodes(t, 1, 1));
  EXPECT_EQ(selected(Corner::bottom_right, t), stitch_nodes(t, 1, 5));
  EXPECT_EQ(selected(Corner::top_left, t), stitch_nodes(t, 4, 1));
  EXPECT_EQ(selected(Corner::top_right, t), stitch_nodes(t, 4, 5));
  const auto all_of = [&](int c0, int c1, int w0, int w1) {
    std::set<int> nodes;
    for (int c = c0; c <= c1; ++c) {
      for (int w = w0; w <= w1; ++w) nodes.merge(stitch_nodes(t, c, w));
    }
    return nodes;
  };
  EXPECT_EQ(selected(Edge::bottom, t), all_of(1, 1, 1, 5));
  EXPECT_EQ(selected(Edge::top, t), all_of(4, 4, 1, 5));
  EXPECT_EQ(selected(Edge::left, t), all_of(1, 4, 1, 1));
  EXPECT_EQ(selected(Edge::right, t), all_of(1, 4, 5, 5));
  EXPECT_EQ(selected(StitchRange{2, 3, 2, 4}, t), all_of(2, 3, 2, 4));
  EXPECT_EQ(selected(YarnPoint{0, 0}, t), (std::set<int>{t.visit_node.front()}));
  EXPECT_EQ(selected(YarnPoint{0, -1}, t), (std::set<int>{t.visit_node.back()}));
  EXPECT_EQ(selected(AllNodes{}, t).size(), idx(t.num_nodes));
  // Seen, not only counted: the top left corner is the highest and leftmost stitch.
  for (const int n : select_nodes(Corner::top_left, t)) {
    EXPECT_LT(test::position(placed, n).x(), 2.9e-3 * 1.01);
    EXPECT_GT(test::position(placed, n).y(), 3 * 2.03e-3 * 0.99);
  }
}

TEST(Compile, LoadsAreSharedAndVelocitiesLand) {
  Scene scene;
  scene.yarns = {line({0, 0, 0}, {0.01, 0, 0}, 4)};
  scene.yarns[0].velocity_m_per_s = {1, 2, 3};
  scene.loads = {{AllNodes{}, {0, -2, 0}}};
  scene.initial_velocities = {{YarnPoint{0, -1}, {7, 0, 0}}};
  const Model model = compile(scene, nullptr);
  EXPECT_EQ(model.load_nodes, (std::vector<int>{0, 1, 2, 3}));
  for (const Vec3& force : model.load_forces) EXPECT_EQ(force, Vec3(0, -0.5, 0));
  EXPECT_EQ(model.start_v.segment<3>(3), Vec3(1, 2, 3));
  EXPECT_EQ(model.start_v.segment<3>(9), Vec3(7, 0, 0));
  EXPECT_EQ(model.start_v.tail(4), VecX::Zero(4));
}

TEST(Compile, ANodeOfSeveralHandlesFollowsTheFirst) {
  Scene scene;
  scene.knit = test::stockinette(3, 3);
  Handle moving{Edge::top, {{1.0, {0, 0.01, 0}, {0, 0, 0}}}, true};
  scene.handles = {Handle{Edge::left, {}, false}, moving};
  const Model model = compile(scene, nullptr);
  ASSERT_EQ(model.handles.size(), 2u);
  EXPECT_EQ(model.handles[0].nodes, select_nodes(Edge::left, model.topology));
  std::set<int> both(model.handles[0].nodes.begin(), model.handles[0].nodes.end());
  for (const int n : model.handles[1].nodes) EXPECT_TRUE(both.insert(n).second);
  EXPECT_TRUE(model.handles[1].fix_arc_length);
  EXPECT_EQ(model.handles[1].motion.size(), 1u);
}

}  // namespace
}  // namespace slipstitch
