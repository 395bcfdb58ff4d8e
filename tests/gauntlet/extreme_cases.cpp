// SPDX-License-Identifier: MIT
// Extreme numbers.
#include <cmath>

#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kStep_s = 1.0 / 240.0;
constexpr double kToAndFro = 1e-3;  // [m], in one step

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
  item.limits.max_crushed_entries = 10;
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

/// All lengths times `scale`; stiffnesses as of one material: EA by its square, EI by its fourth power. What the solver
/// leaves of forces and speeds is the same share of them.
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
  FixedNumerics numerics;
  numerics.force_tolerance_n *= scale * scale;
  numerics.velocity_tolerance_m_per_s *= scale;
  scene.numerics = numerics;
  return item;
}

GauntletCase friction(const char* name, double coefficient) {
  GauntletCase item = named(name, "sliding friction far from any yarn's", swatch(6, 6));
  hang(item.scene);
  item.scene.effects.sliding_friction->coefficient = coefficient;
  return item;
}

/// A load of 0.05 N keeps the yarn taut. It slips through the crossing at 0.05 N of friction, 1 mm each step.
GauntletCase switching_friction() {
  GauntletCase item = named("friction-switching", "a yarn drawn through a crossing, the other way at every step", {});
  Scene& scene = item.scene;
  BareYarn drawn, across;
  for (int i = 0; i <= 4; ++i) {
    drawn.points.push_back({0.01 * (i - 2), 0, 0});
    across.points.push_back({0, 0, 0.01 * (i - 2)});
  }
  scene.yarns = {drawn, across};
  scene.crossings = {{0, 2, 1, 2}};
  Effects& on = scene.effects;
  on.inertia.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.sliding.emplace();
  on.sliding_friction = SlidingFrictionEffect{.coefficient = 0.5, .normal_force_n = 0.1};
  on.damping = DampingEffect{.stretch_ns = 1e-3, .bending_nm2s = 1e-8, .sliding_ns_per_m = 0.1};
  scene.handles = {pin(YarnPoint{1, 0}), pin(YarnPoint{1, -1}), pin(YarnPoint{0, -1})};
  scene.duration_s = 0.2;
  for (int k = 1; k * kStep_s <= scene.duration_s; ++k)
    scene.handles[2].motion.push_back({k * kStep_s, {k % 2 == 0 ? 0.0 : kToAndFro, 0, 0}, Vec3::Zero()});
  scene.loads = {{YarnPoint{0, 0}, {-0.05, 0, 0}}};
  item.about_motion = true;
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
          friction("sliding-friction-1", 1.0),
          friction("sliding-friction-10", 10.0),
          switching_friction()};
}

GauntletCase largest_case() {
  GauntletCase item = named("two-hundred-courses", "200 x 200 stitches for ten steps", swatch(200, 200));
  hang(item.scene);
  item.scene.duration_s = 10.0 * kStep_s;
  return item;
}

std::vector<GauntletCase> gauntlet_cases() {
  std::vector<GauntletCase> all;
  for (const auto& group : {yarn_cases(), swatch_cases(), collision_cases(), extreme_cases()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace slipstitch::gauntlet
