// SPDX-License-Identifier: MIT
#include "study/growing_sets.h"

#include <algorithm>

#include "model/effect_list.h"

namespace slipstitch {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Of the listed effects of a scene, those of the first `stages` stages.
Effects first_stages(const Effects& all, int stages) {
  Effects effects = all;
  const std::vector<EffectStage> order = effect_stages();
  for (std::size_t i = static_cast<std::size_t>(stages); i < order.size(); ++i)
    for (const std::string& name : order[i].effects) remove_effect(effects, *find_effect(name));
  return effects;
}

GrowingSet run_set(const Scene& scene, int threads, const std::function<bool()>& should_stop) {
  GrowingSet set;
  RunHooks hooks;
  hooks.on_header = [&](const FrameHeader& header) { set.header = header; };
  hooks.on_frame = [&](const Frame& frame) { set.last = frame; };
  hooks.should_stop = should_stop;
  const RunSummary summary = run(scene, threads, hooks);
  set.wall_s = summary.wall_s;
  if (summary.status != RunStatus::succeeded)
    set.failure = summary.status == RunStatus::cancelled ? "stopped" : summary.message;
  return set;
}

}  // namespace

std::vector<EffectStage> effect_stages() {
  return {{"yarn",
           {"inertia", "gravity", "stretch", "bending", "bending_jamming", "damping", "air_drag", "wind", "shrinkage",
            "plasticity"}},
          {"colliders", {"colliders"}},
          {"wrapping", {"wrapping"}},
          {"sliding", {"sliding", "contact_length", "parallel_contact", "sliding_friction"}},
          {"self-collision", {"self_collision"}}};
}

std::vector<GrowingSet> run_growing_sets(const Scene& scene, int threads,
                                         const std::function<void(int done, int of)>& on_stage,
                                         const std::function<bool()>& should_stop) {
  const std::vector<std::string> listed = effect_names(scene.effects);
  const std::vector<EffectStage> stages = effect_stages();
  std::vector<GrowingSet> sets;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    std::vector<std::string> added;
    std::copy_if(stages[i].effects.begin(), stages[i].effects.end(), std::back_inserter(added),
                 [&](const std::string& name) { return holds(listed, name); });
    if (added.empty()) continue;
    if (should_stop && should_stop()) break;
    if (on_stage) on_stage(static_cast<int>(i), static_cast<int>(stages.size()));
    Scene part = scene;
    part.effects = first_stages(scene.effects, static_cast<int>(i) + 1);
    sets.push_back(run_set(part, threads, should_stop));
    sets.back().stage = stages[i].name;
    sets.back().added = std::move(added);
  }
  return sets;
}

}  // namespace slipstitch
