// SPDX-License-Identifier: MIT
// Extreme numbers.
#include <cmath>

#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {
namespace {

GauntletCase stiff_in_stretch() {
  GauntletCase item = named("stretch-times-1000", "yarn a thousand times stiffer in stretch", swatch(6, 6));
  hang(item.scene);
  item.scene.yarn.stretch_n *= 1e3;
  return item;
}

GauntletCase stiff_in_bending() {
  GauntletCase item = named("bending-times-1000", "yarn a thousand times stiffer in bending", swatch(6, 6));
  hang(item.scene);
  item.scene.yarn.bending_nm2 *= 1e3;
  item.limits.max_stretch = 3.0;
  item.limits.max_ridge_entries = 30;
  item.limits.max_fade_entries = 250;
  return item;
}

GauntletCase heavy() {
  GauntletCase item =
      named("gravity-times-1000", "hangs by two corners under a thousand times its weight", swatch(6, 6));
  hang(item.scene);
  item.scene.effects.gravity->acceleration_m_per_s2 *= 1000.0;
  item.limits.max_stretch = 3.0;
  return item;
}

/// All lengths times `scale`; stiffnesses as of one material: EA by its square, EI by its fourth power.
GauntletCase scaled(const char* name, double radius) {
  GauntletCase item = named(name, "the same fabric of yarn of another size", swatch(5, 5));
  hang(item.scene);
  Scene& scene = item.scene;
  const double scale = radius / scene.yarn.radius_m;
  scene.knit->gauge = {2.9e-3 * scale, 2.03e-3 * scale, {}};
  scene.yarn.radius_m *= scale;
  scene.yarn.linear_density_kg_per_m *= scale * scale;
  scene.yarn.stretch_n *= scale * scale;
  scene.yarn.bending_nm2 *= std::pow(scale, 4);
  DampingEffect& damping = *scene.effects.damping;
  damping.bending_nm2s *= std::pow(scale, 4);
  damping.wrapping_ns *= scale * scale;
  *damping.sliding_ns_per_m *= scale;
  return item;
}

GauntletCase friction(const char* name, double coefficient) {
  GauntletCase item = named(name, "sliding friction far from any yarn's", swatch(6, 6));
  hang(item.scene);
  item.scene.effects.sliding_friction->coefficient = coefficient;
  return item;
}

}  // namespace

std::vector<GauntletCase> extreme_cases() {
  return {stiff_in_stretch(),
          stiff_in_bending(),
          heavy(),
          scaled("radius-10-um", 10e-6),
          scaled("radius-10-mm", 10e-3),
          friction("sliding-friction-0", 0.0),
          friction("sliding-friction-10", 10.0)};
}

std::vector<GauntletCase> gauntlet_cases() {
  std::vector<GauntletCase> all;
  for (const auto& group : {yarn_cases(), swatch_cases(), collision_cases(), extreme_cases()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace slipstitch::gauntlet
