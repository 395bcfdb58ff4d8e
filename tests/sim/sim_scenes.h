// SPDX-License-Identifier: MIT
#pragma once

#include "support/knit_scene.h"

namespace slipstitch::testing {

inline Handle held(int yarn, int point, bool fix_arc_length = false) {
  return Handle{YarnPoint{yarn, point}, {}, fix_arc_length};
}

/// A yarn of four pieces, 0.2 m long, held at its first point, horizontal at the start.
inline Scene hanging_yarn() {
  Scene scene;
  scene.name = "hanging yarn";
  BareYarn yarn;
  for (int i = 0; i < 5; ++i) yarn.points.push_back({0.05 * i, 0.0, 0.0});
  scene.yarns = {yarn};
  scene.handles = {held(0, 0)};
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1e-2, .stretch_n = 5.0, .bending_nm2 = 1e-5};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  return scene;
}

/// Two yarns of four pieces that cross at their middles.
inline Scene crossed_yarns() {
  Scene scene = hanging_yarn();
  BareYarn other;
  for (int i = 0; i < 5; ++i) other.points.push_back({0.1, 0.0, 0.05 * (i - 2)});
  scene.yarns.push_back(other);
  scene.crossings = {{0, 2, 1, 2}};
  scene.effects.sliding.emplace();
  return scene;
}

/// A yarn that swings, slides over another one, is damped in every way and blown at, one of its ends on the move.
inline Scene smooth_motion() {
  Scene scene = crossed_yarns();
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1e-2, .stretch_n = 2.0, .bending_nm2 = 1e-5};
  scene.handles = {held(0, 0), held(0, -1), held(1, 0), held(1, -1)};
  scene.handles[1].velocity_m_per_s = Vec3(0.2, 0.1, 0.3);
  scene.initial_velocities = {{AllNodes{}, {0.1, -0.2, 0.2}}};
  Effects& on = scene.effects;
  on.inertia->sliding_mass_fraction = 0.5;
  on.damping = DampingEffect{.stretch_ns = 1e-3, .bending_nm2s = 1e-7, .sliding_ns_per_m = 0.05};
  on.air_drag.emplace();
  on.wind = WindEffect{{0.5, 0.0, 1.0}, {0.0, 0.5, 0.5}, 0.05};
  return scene;
}

/// A free swatch with every effect of a knit but gravity.
inline Scene free_swatch(int courses, int wales) {
  Scene scene = test::knit_scene("stockinette", courses, wales);
  scene.name = "swatch";
  scene.knit->noise_m = 1e-5;
  scene.effects.damping = DampingEffect{1e-3, 1e-10, 1e-6, 1e-3};
  scene.duration_s = 0.04;
  return scene;
}

}  // namespace slipstitch::testing
