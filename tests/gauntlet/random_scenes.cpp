// SPDX-License-Identifier: MIT
#include "gauntlet/random_scenes.h"

#include <algorithm>

#include "force/segments.h"
#include "gauntlet/random_parts.h"
#include "model/effect_list.h"
#include "sim/prepare.h"

namespace slipstitch::gauntlet {
namespace {

double start_stretch(const Model& model) {
  double most = 1.0;
  const VecX& q = model.start_q;
  for_each_owned_segment(model.topology, [&](int, int i) {
    const auto c = segment_coords(model.topology, i);
    most = std::max(most, (q.segment<3>(c[4]) - q.segment<3>(c[0])).norm() / (q[c[7]] - q[c[3]]));
  });
  return most;
}

/// One wrap that is turned over or straightened by a script is not broken, most of them are; of segments hardly any are
/// crushed.
void limit_safeguards(const Model& model, Limits& limits) {
  const long wraps = 2 * static_cast<long>(model.topology.contacts.size());
  limits.max_ridge_entries = wraps / 4;
  limits.max_fade_entries = 2 * wraps;
  limits.max_crushed_entries = model.topology.num_visits() / 20;
}

bool is_drawn(const Handle& handle) { return !handle.motion.empty() || handle.velocity_m_per_s; }

bool any_drawn(const Scene& scene) { return std::any_of(scene.handles.begin(), scene.handles.end(), is_drawn); }

bool any_body_moves(const Scene& scene) {
  if (!scene.effects.colliders) return false;
  const auto& all = scene.effects.colliders->colliders;
  return std::any_of(all.begin(), all.end(), [](const Collider& c) { return c.dynamic || !c.motion.empty(); });
}

/// Held yarn follows what draws or strikes it, whatever its length is.
double most_stretch(const Scene& scene, const Model& model) {
  const bool strained = any_drawn(scene) || (!scene.handles.empty() && any_body_moves(scene));
  return std::max(strained ? 2.5 : 1.5, 1.1 * start_stretch(model));
}

/// Yarn with a free end may be pulled out where it slides, and drawn yarn may run out between two contacts.
bool may_end_early(const Scene& scene) {
  if (!scene.effects.sliding) return false;
  return any_drawn(scene) || !scene.loads.empty() || !scene.guides.empty() || !scene.crossings.empty();
}

}  // namespace

GauntletCase random_case(std::uint64_t seed) {
  Draft draft(seed);
  draw_times(draft);
  draw_material(draft);
  draw_fabric(draft);
  draw_effects(draft);
  GauntletCase item;
  item.name = "seed-" + std::to_string(seed);
  // Scripts and bodies are placed beside the fabric as it lies. A repeat that cannot be relaxed is left to the run.
  const Prepared prepared = prepare(draft.scene);
  if (!prepared.failure) {
    draw_scripts(draft, prepared.model);
    draw_colliders(draft, prepared.model);
    keep_scripts_clear(draft, prepared.model);
    item.limits.max_stretch = most_stretch(draft.scene, prepared.model);
    limit_safeguards(prepared.model, item.limits);
  }
  item.about = draft.about;
  item.scene = std::move(draft.scene);
  item.limits.impossible = may_end_early(item.scene);
  item.limits.max_steps = 20L * draft.steps;
  item.about_motion = item.scene.effects.inertia.has_value();
  return item;
}

}  // namespace slipstitch::gauntlet
