// SPDX-License-Identifier: MIT
// Single yarns, and the ends and edges of fabric.
#include <cmath>

#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {
namespace {

BareYarn straight(const Vec3& from, const Vec3& to, int pieces) {
  BareYarn yarn;
  for (int i = 0; i <= pieces; ++i) yarn.points.push_back(from + (to - from) * i / pieces);
  return yarn;
}

/// Two yarns that cross a third, one of them loaded along it until it meets the other.
GauntletCase slide_into_neighbour() {
  GauntletCase item =
      named("slide-into-neighbour", "a crossing that a load drives along its yarn into the next crossing", {});
  Scene& scene = item.scene;
  scene.yarns = {straight({-0.02, 0, 0}, {0.02, 0, 0}, 8), straight({-0.005, 0, -0.02}, {-0.005, 0, 0.02}, 8),
                 straight({0, 0, -0.02}, {0, 0, 0.02}, 8)};
  scene.crossings = {{0, 3, 1, 4}, {0, 4, 2, 4}};
  Effects& on = scene.effects;
  on.inertia.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.sliding.emplace();
  on.parallel_contact.emplace();
  on.self_collision.emplace();
  on.damping = DampingEffect{.bending_nm2s = 1e-8, .sliding_ns_per_m = 1.0};
  for (int yarn : {0, 2})
    for (int point : {0, -1}) scene.handles.push_back({YarnPoint{yarn, point}, {}});
  scene.loads = {{YarnPoint{1, 4}, {0.05, 0, 0}}};
  scene.duration_s = 0.3;
  return item;
}

GauntletCase snag() {
  GauntletCase item = named("snag", "one yarn end is pulled out of the fabric at 1 m/s", swatch(6, 6));
  item.scene.handles = {pin(Edge::bottom), pin(YarnPoint{0, -1})};
  item.scene.handles[1].velocity_m_per_s = Vec3(0.3, 0.5, 0.8).normalized();
  item.scene.duration_s = 0.05;
  item.limits.max_stretch = 4.0;
  item.about_motion = true;
  item.limits.max_fade_entries = 50;
  item.limits.impossible = true;  // soft yarn gives all that its stitches have before they tighten
  return item;
}

/// A yarn drawn through a crossing until its end arrives there.
GauntletCase pulled_through() {
  GauntletCase item = named("pulled-through", "a yarn is drawn through a crossing until its end would leave it", {});
  Scene& scene = item.scene;
  scene.yarns = {straight({-0.01, 0, 0}, {0.02, 0, 0}, 3), straight({0, 0, -0.02}, {0, 0, 0.02}, 8)};
  scene.crossings = {{0, 1, 1, 4}};
  Effects& on = scene.effects;
  on.inertia.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.sliding.emplace();
  on.sliding_friction.emplace();
  scene.handles = {pin(YarnPoint{1, 0}), pin(YarnPoint{1, -1}), pin(YarnPoint{0, -1})};
  scene.handles[2].velocity_m_per_s = Vec3(0.1, 0, 0);
  scene.duration_s = 0.3;
  item.limits.impossible = true;
  return item;
}

GauntletCase pulled_loop() {
  GauntletCase item =
      named("pulled-loop", "a corner loop drawn out far beyond the yarn that it can take in", swatch(4, 4));
  item.scene.effects.sliding_friction.reset();
  item.scene.handles = {pin(Edge::top), pin(Corner::bottom_left)};
  item.scene.handles[1].velocity_m_per_s = Vec3(-0.1, -0.2, 0.0);
  item.scene.duration_s = 0.2;
  item.limits.max_stretch = 6.0;
  item.limits.impossible = true;  // its neighbours have no more yarn to give
  item.about_motion = true;
  item.limits.max_ridge_entries = 5;
  return item;
}

GauntletCase selvedge_corner() {
  GauntletCase item =
      named("selvedge-corner", "the corner with missing neighbours is pulled out of the plane", swatch(5, 5));
  item.scene.handles = {pin(Edge::top), pin(Corner::bottom_right)};
  item.scene.handles[1].motion = {{0.1, {2e-3, -2e-3, 6e-3}, Vec3::Zero()}};
  item.limits.max_ridge_entries = 8;
  return item;
}

/// A yarn with a point that has no length of yarn to either side: D -> 0 from the start.
GauntletCase crowded_yarn() {
  GauntletCase item =
      named("crowded-yarn", "segments from a hundred thousandth to all of their neighbour's length", {});
  BareYarn yarn;
  double x = 0.0;
  for (int i = 0; i < 12; ++i) {
    yarn.points.push_back({x, 0, 0});
    x += i % 2 == 0 ? 1e-2 : 1e-7 * std::pow(10.0, i / 2);
  }
  item.scene.yarns = {yarn};
  item.scene.handles = {pin(YarnPoint{0, 0})};
  Effects& on = item.scene.effects;
  on.inertia.emplace();
  on.gravity.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.damping = DampingEffect{.bending_nm2s = 1e-9, .sliding_ns_per_m = std::nullopt};
  item.scene.duration_s = 0.1;
  return item;
}

}  // namespace

std::vector<GauntletCase> yarn_cases() {
  return {slide_into_neighbour(), snag(), pulled_through(), pulled_loop(), selvedge_corner(), crowded_yarn()};
}

}  // namespace slipstitch::gauntlet
