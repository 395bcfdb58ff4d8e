// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/effects.h"

namespace slipstitch {

/// One effect of the catalogue and how it is switched.
struct EffectEntry {
  const char* name;       // as in the schema
  const char* needs;      // effect without which it is refused; empty: none
  bool needs_parameters;  // means nothing without those that a scene gives
  bool (*listed)(const Effects&);
  void (*add)(Effects&);  // with default parameters
  void (*remove)(Effects&);
};

/// The one list of effects, prerequisites before what needs them.
std::span<const EffectEntry> effect_list();
/// nullptr: there is no such effect.
const EffectEntry* find_effect(std::string_view name);

/// Names of the listed effects, in the order of effect_list().
std::vector<std::string> effect_names(const Effects& effects);

/// Takes an effect away, and with it all that need it; returns the names of those others that were listed.
std::vector<std::string> remove_effect(Effects& effects, const EffectEntry& effect);

}  // namespace slipstitch
