// SPDX-License-Identifier: MIT
#include "model/effect_list.h"

#include <gtest/gtest.h>

#include <set>

namespace slipstitch {
namespace {

TEST(EffectList, NamesEachOnceAndPrerequisitesFirst) {
  std::set<std::string_view> names;
  for (const EffectEntry& effect : effect_list()) {
    EXPECT_TRUE(*effect.needs == '\0' || names.contains(effect.needs)) << effect.name;
    EXPECT_TRUE(names.insert(effect.name).second) << effect.name;
    EXPECT_EQ(find_effect(effect.name), &effect);
  }
  EXPECT_EQ(find_effect("no such effect"), nullptr);
}

TEST(EffectList, SwitchesTheEffectThatItNamesAndNoOther) {
  for (const EffectEntry& effect : effect_list()) {
    Effects effects;
    EXPECT_FALSE(effect.listed(effects)) << effect.name;
    effect.add(effects);
    EXPECT_EQ(effect_names(effects), std::vector<std::string>{effect.name});
    effect.remove(effects);
    EXPECT_TRUE(effect_names(effects).empty()) << effect.name;
  }
}

TEST(EffectList, TakesAwayWhatNeedsWhatIsTakenAway) {
  Effects effects;
  for (const EffectEntry& effect : effect_list()) effect.add(effects);
  effects.damping->sliding_ns_per_m = 1.0;
  EXPECT_EQ(remove_effect(effects, *find_effect("sliding")),
            (std::vector<std::string>{"contact_length", "parallel_contact", "sliding_friction"}));
  EXPECT_FALSE(effects.damping->sliding_ns_per_m);
  EXPECT_EQ(remove_effect(effects, *find_effect("inertia")), (std::vector<std::string>{"air_drag", "wind"}));
  EXPECT_FALSE(effects.wind);
}

}  // namespace
}  // namespace slipstitch
