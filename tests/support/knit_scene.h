// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "model/scene.h"

namespace slipstitch::test {

/// A free swatch of the demo yarn and gauge with every effect of a knit at its default, but no gravity.
inline Scene knit_scene(const std::string& preset, int courses, int wales) {
  Scene scene;
  scene.name = preset;
  Issues issues;
  scene.knit.emplace().pattern = pattern_from_preset({preset, courses, wales}, false, "preset", issues);
  EXPECT_TRUE(issues.empty());
  scene.knit->gauge = {2.9e-3, 2.03e-3, {}};
  Effects& effects = scene.effects;
  effects.inertia.emplace();
  effects.stretch.emplace();
  effects.bending.emplace();
  effects.bending_jamming.emplace();
  effects.wrapping.emplace();
  effects.contact_length.emplace();
  effects.parallel_contact.emplace();
  effects.sliding.emplace();
  effects.sliding_friction.emplace();
  effects.damping.emplace();
  return scene;
}

/// The demo's: a soft wrapping and enough damping to come to rest in a third of a second.
inline void use_demo_feel(Effects& effects) {
  effects.wrapping->alpha = 0.03;
  effects.damping =
      DampingEffect{.stretch_ns = 0.0, .bending_nm2s = 1.35e-8, .wrapping_ns = 9e-3, .sliding_ns_per_m = 10.0};
}

}  // namespace slipstitch::test
