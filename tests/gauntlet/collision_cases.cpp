// SPDX-License-Identifier: MIT
// Fabric and bodies.
#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {
namespace {

/// Lies flat in the plane y = height, its right side up.
Scene lying(int courses, int wales, double height) {
  Scene scene = swatch(courses, wales);
  scene.knit->placement = {{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
  scene.effects.gravity.emplace();
  return scene;
}

GauntletCase sharp_edge() {
  GauntletCase item = named("sharp-edge", "falls over the edge of a box, which has no radius", lying(8, 6, 1.5e-3));
  Box box{{0.0, -0.05, 0.0}, {0.006, 0.05, 0.05}, Vec3::Zero()};
  put(item.scene, {body(box)});
  item.about_motion = true;
  return item;
}

GauntletCase heap() {
  GauntletCase item = named("heap", "a strip falls end on and piles up on the floor", swatch(14, 4));
  item.scene.effects.gravity.emplace();
  item.scene.effects.self_collision.emplace();
  item.scene.knit->placement.origin_m = {0, 2e-3, 0};
  put(item.scene, {body(Plane{})});
  item.scene.initial_velocities = {{AllNodes{}, {0, -0.5, 0}}};
  item.scene.duration_s = 0.15;
  item.about_motion = true;
  return item;
}

GauntletCase fast_sphere() {
  GauntletCase item = named("sphere-at-20-m/s", "a sphere of 5 mm flies into it at 20 m/s", swatch(8, 8));
  item.scene.handles = {pin(Edge::top), pin(Edge::bottom)};
  Collider ball = body(Sphere{{8e-3, 8e-3, 10e-3}, 2.5e-3});
  ball.dynamic = DynamicBody{2e-4, {0, 0, -20.0}};
  put(item.scene, {ball});
  item.scene.duration_s = 0.02;
  std::get<FixedNumerics>(item.scene.numerics).time_step_s = 1.0 / 2000;
  item.scene.frames_per_s = 500.0;
  item.limits.max_stretch = 6.0;
  item.about_motion = true;
  item.limits.max_ridge_entries = 5;
  return item;
}

GauntletCase slippery_and_rough() {
  GauntletCase item =
      named("friction-0-and-10", "falls onto two slopes, one without friction and one with ten", lying(6, 6, 9e-3));
  put(item.scene, {body(Plane{{6e-3, 0, 0}, {1, 2, 0}}, 0.0), body(Plane{{6e-3, 0, 0}, {-1, 2, 0}}, 10.0)});
  item.about_motion = true;
  return item;
}

GauntletCase light_sphere() {
  GauntletCase item =
      named("mass-ratio-1e-6", "a sphere of a millionth of the fabric's mass lies on it", lying(6, 6, 0.0));
  item.scene.handles = {pin(Edge::top), pin(Edge::bottom)};
  Collider ball = body(Sphere{{6e-3, 5e-3, -6e-3}, 3e-3});
  ball.dynamic = DynamicBody{2e-11};
  put(item.scene, {ball});
  item.about_motion = true;
  return item;
}

GauntletCase heavy_sphere() {
  GauntletCase item =
      named("mass-ratio-1e6", "a sphere a million times as heavy as a node lies in it", lying(8, 8, 0.0));
  item.scene.handles = {pin(Edge::top), pin(Edge::bottom), pin(Edge::left), pin(Edge::right)};
  Collider ball = body(Sphere{{8e-3, 4.2e-3, -8e-3}, 3e-3});
  ball.dynamic = DynamicBody{0.15};
  put(item.scene, {ball});
  item.limits.rest_speed_m_per_s = 1e-3;
  item.limits.max_stretch = 2.0;
  item.about_motion = true;
  return item;
}

}  // namespace

std::vector<GauntletCase> collision_cases() {
  return {sharp_edge(), heap(), fast_sphere(), slippery_and_rough(), light_sphere(), heavy_sphere()};
}

}  // namespace slipstitch::gauntlet
