// SPDX-License-Identifier: MIT
#include "model/effect_list.h"

#include <array>

namespace slipstitch {
namespace {

enum class Parameters { have_defaults, from_scene };

template <auto kMember>
constexpr EffectEntry entry(const char* name, const char* needs = "",
                            Parameters parameters = Parameters::have_defaults) {
  return {name,
          needs,
          parameters == Parameters::from_scene,
          [](const Effects& effects) { return (effects.*kMember).has_value(); },
          [](Effects& effects) { (effects.*kMember).emplace(); },
          [](Effects& effects) { (effects.*kMember).reset(); }};
}

constexpr std::array kEffects{
    entry<&Effects::inertia>("inertia"),
    entry<&Effects::gravity>("gravity"),
    entry<&Effects::stretch>("stretch"),
    entry<&Effects::bending>("bending"),
    entry<&Effects::bending_jamming>("bending_jamming", "bending"),
    entry<&Effects::wrapping>("wrapping"),
    entry<&Effects::sliding>("sliding"),
    entry<&Effects::contact_length>("contact_length", "sliding"),
    entry<&Effects::parallel_contact>("parallel_contact", "sliding"),
    entry<&Effects::sliding_friction>("sliding_friction", "sliding"),
    entry<&Effects::damping>("damping"),
    entry<&Effects::colliders>("colliders", "", Parameters::from_scene),
    entry<&Effects::self_collision>("self_collision"),
    entry<&Effects::air_drag>("air_drag", "inertia"),
    entry<&Effects::wind>("wind", "air_drag", Parameters::from_scene),
    entry<&Effects::shrinkage>("shrinkage", "stretch", Parameters::from_scene),
    entry<&Effects::plasticity>("plasticity", "bending"),
};

}  // namespace

std::span<const EffectEntry> effect_list() { return kEffects; }

const EffectEntry* find_effect(std::string_view name) {
  for (const EffectEntry& effect : kEffects)
    if (name == effect.name) return &effect;
  return nullptr;
}

std::vector<std::string> effect_names(const Effects& effects) {
  std::vector<std::string> names;
  for (const EffectEntry& effect : kEffects)
    if (effect.listed(effects)) names.emplace_back(effect.name);
  return names;
}

std::vector<std::string> remove_effect(Effects& effects, const EffectEntry& effect) {
  std::vector<std::string> others;
  effect.remove(effects);
  if (effects.damping && !effects.sliding) effects.damping->sliding_ns_per_m.reset();
  for (const EffectEntry& other : kEffects) {
    if (std::string_view(other.needs) != effect.name || !other.listed(effects)) continue;
    others.emplace_back(other.name);
    for (std::string& name : remove_effect(effects, other)) others.push_back(std::move(name));
  }
  return others;
}

}  // namespace slipstitch
