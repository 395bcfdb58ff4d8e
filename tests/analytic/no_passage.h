// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>

#include "analytic_helpers.h"
#include "collide/rigid_body.h"
#include "sim/run.h"

namespace slipstitch::testing {

inline constexpr double kR = 0.524e-3;

inline void list_yarn_effects(Scene& scene) {
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
}

inline Handle carried(Selector where, const Vec3& velocity) {
  Handle handle;
  handle.where = where;
  handle.velocity_m_per_s = velocity;
  return handle;
}

using Look = std::function<void(const Simulation&)>;

inline void run_watched(const Scene& scene, double duration_s, const Look& look) {
  Scene timed = scene;
  timed.duration_s = duration_s;
  for (const Issue& issue : check(timed)) ADD_FAILURE() << issue.path << ": " << issue.value;
  RunHooks hooks;
  hooks.on_step = [&](Simulation& sim, const StepReport& report) {
    if (report.accepted) look(sim);
  };
  const RunSummary summary = run(timed, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
}

/// A yarn over a guide that lets its hanging end grow from 3 mm to 63 mm within 0.4 s.
inline Scene let_down() {
  Scene scene;
  BareYarn yarn;
  yarn.points = {{-0.1, 0, 0}, {0, 0, 0}, {0, -3e-3, 0}};
  scene.yarns = {yarn};
  scene.guides = {{0, 1}};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.sliding.emplace();
  scene.effects.damping.emplace().sliding_ns_per_m = 2.0;
  scene.handles = {pin(0, 0)};
  scene.handles[0].motion = {{0.4, {0.06, 0, 0}, Vec3::Zero()}};
  scene.loads = {{YarnPoint{0, 2}, {0, -0.01, 0}}};
  return scene;
}

/// Deepest overlap of yarn 0's last segment with collider 0, along all of it, over the run [m].
inline double deepest(const Scene& scene, double duration_s) {
  double depth = -1.0;
  RigidBody body(scene.effects.colliders->colliders[0]);
  run_watched(scene, duration_s, [&](const Simulation& sim) {
    body.move_to(sim.state().t);
    for (int k = 0; k <= 400; ++k) {
      const double s = k / 400.0;
      const Vec3 x = (1.0 - s) * position(sim, 0, -2) + s * position(sim, 0, -1);
      depth = std::max(depth, kR - body.distance(x).phi);
    }
  });
  return depth;
}

}  // namespace slipstitch::testing
