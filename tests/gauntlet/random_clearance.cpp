// SPDX-License-Identifier: MIT
// Held yarn of random scenes stays out of their bodies: the two scripts could not both be followed.
#include "collide/rigid_body.h"
#include "gauntlet/random_parts.h"
#include "model/select.h"
#include "sim/simulation.h"

namespace slipstitch::gauntlet {
namespace {

constexpr int kLooks = 60;      // at the scripts, over the run
constexpr double kClear = 1.1;  // radii from the yarn's middle to a body

/// As compile() does, of a model whose yarn is the scene's.
std::vector<ScriptedNodes> scripted(const Scene& scene, const Model& model) {
  std::vector<ScriptedNodes> all;
  for (const Handle& handle : scene.handles)
    all.push_back({select_nodes(handle.where, model.topology), handle.motion, handle.fix_arc_length,
                   handle.velocity_m_per_s.value_or(Vec3::Zero()), 0});
  return all;
}

bool clear(const Draft& draft, Model& model, const std::vector<ScriptedNodes>& guides) {
  const double clearance = kClear * draft.radius();
  model.handles = scripted(draft.scene, model);
  model.handles.insert(model.handles.end(), guides.begin(), guides.end());
  for (const Collider& collider : draft.scene.effects.colliders->colliders) {
    if (collider.dynamic) continue;
    RigidBody body(collider);
    for (int look = 0; look <= kLooks; ++look) {
      const double t = draft.duration_s() * look / kLooks;
      VecX q = model.start_q;
      apply_scripts(model, t, q);
      body.move_to(t);
      for (const ScriptedNodes& handle : model.handles)
        for (const int n : handle.nodes)
          if (body.distance(q.segment<3>(3 * n)).phi < clearance) return false;
    }
  }
  return true;
}

}  // namespace

void keep_scripts_clear(Draft& draft, Model model) {
  Scene& scene = draft.scene;
  if (!scene.effects.colliders) return;
  const std::vector<ScriptedNodes> guides = model.handles;
  if (clear(draft, model, guides)) return;
  for (Collider& collider : scene.effects.colliders->colliders) collider.motion.clear();
  draft.say("bodies stopped");
  if (clear(draft, model, guides)) return;
  for (Handle& handle : scene.handles) {
    handle.motion.clear();
    handle.velocity_m_per_s.reset();
  }
  draft.say("handles stopped");
}

}  // namespace slipstitch::gauntlet
