// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/sim_scenes.h"

namespace slipstitch::testing {

inline Scene moving(Scene scene, double duration_s) {
  scene.duration_s = duration_s;
  return scene;
}

inline Scene hung_swatch(const char* preset, int courses, int wales, double alpha) {
  Scene scene = test::knit_scene(preset, courses, wales);
  test::use_demo_feel(scene.effects);
  scene.effects.wrapping->alpha = alpha;
  scene.effects.gravity.emplace();
  scene.knit->placement.wale_direction = -Vec3::UnitZ();
  scene.handles = {Handle{Corner::top_left, {}}, Handle{Corner::top_right, {}}};
  return scene;
}

inline Scene pulled_swatch() {
  Scene scene = hung_swatch("garter", 5, 6, 0.03);
  scene.handles = {Handle{Edge::left, {}}, Handle{Edge::right, {{0.0}, {0.1, {0.004, 0.0, 0.0}}, {0.2}}}};
  return scene;
}

inline Scene dropped_swatch() {
  Scene scene = hung_swatch("stockinette", 4, 4, 0.03);
  scene.handles.clear();
  Collider plane;
  plane.shape = Plane{{0.0, -0.005, 0.0}, Vec3::UnitY()};
  scene.effects.colliders.emplace().colliders = {plane};
  scene.effects.self_collision.emplace();
  return scene;
}

inline Scene with(Scene scene, Integrator integrator) {
  std::get<FixedNumerics>(scene.numerics).integrator = integrator;
  return scene;
}

inline Scene to(Scene scene, double tolerance_m) {
  scene.numerics = AccuracyNumerics{tolerance_m};
  return scene;
}

/// Ten scenes, no two alike, none of which runs for long.
inline std::vector<Scene> varied_scenes() {
  return {moving(hanging_yarn(), 1.0),
          moving(smooth_motion(), 0.5),
          moving(hung_swatch("stockinette", 6, 6, 1.0), 0.3),
          moving(hung_swatch("rib", 6, 4, 0.03), 0.3),
          moving(pulled_swatch(), 0.3),
          moving(dropped_swatch(), 0.3),
          moving(with(hung_swatch("seed", 4, 6, 0.1), Integrator::sdirk2), 0.2),
          moving(with(hung_swatch("stockinette", 5, 5, 0.03), Integrator::bdf2), 0.3),
          to(moving(smooth_motion(), 0.5), 1e-4),
          to(moving(hung_swatch("stockinette", 4, 4, 0.03), 0.2), 1e-3)};
}

}  // namespace slipstitch::testing
