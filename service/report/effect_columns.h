// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "study/effect_study.h"

namespace slipstitch {

/// A number that every comparison of an effect study has.
struct EffectColumn {
  const char* title;    // short, for tables that people read
  const char* meaning;  // a sentence
  double (*value)(const EffectPrice& price, const EffectStudy& study);
};

/// Those that people read: what moves, ratios with / without, and forces and energies with - without.
std::span<const EffectColumn> effect_columns();

/// A value as it stands in a table: ratios and lengths in three digits, NaN as "-".
std::string cell_text(double value);

/// "on", or "added": not listed, but with default parameters in the comparison.
std::string_view presence_text(const EffectPrice& price);
/// The effect, and in brackets those that go with it.
std::string effect_label(const EffectPrice& price);

/// What all tables of a study have below them.
std::string how_to_read();
/// Size, rounds and cost of the scene itself, one sentence.
std::string about_scene(const EffectStudy& study);

}  // namespace slipstitch
