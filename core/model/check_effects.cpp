// SPDX-License-Identifier: MIT
#include "model/check_parts.h"
#include "model/effect_list.h"

namespace slipstitch {
namespace {

void check_prerequisites(const Effects& effects, Checker& check) {
  const auto needs = [&](const std::string& field, const std::string& needed) {
    check.fail("effects." + field, "listed", "effects." + needed + " listed too");
  };
  for (const EffectEntry& effect : effect_list()) {
    const EffectEntry* needed = find_effect(effect.needs);
    if (needed != nullptr && effect.listed(effects) && !needed->listed(effects)) needs(effect.name, effect.needs);
  }
  if (effects.damping && effects.damping->sliding_ns_per_m && !effects.sliding) needs("damping.sliding_ns_per_m", "sliding");
}

void check_auto(const AutoEffects& automatic, Checker& check) {
  if (automatic.tolerance_m) check.positive("effects.auto.tolerance_m", *automatic.tolerance_m);
  if (automatic.window_s) check.positive("effects.auto.window_s", *automatic.window_s);
}

void check_wrapping(const WrappingEffect& wrapping, Checker& check) {
  check.not_negative("effects.wrapping.alpha", wrapping.alpha);
  if (wrapping.stiffness_n) check.not_negative("effects.wrapping.stiffness_n", *wrapping.stiffness_n);
  const double angle = wrapping.rest_angle_rad;
  check.require(angle >= 0.0 && angle < kPi, "effects.wrapping.rest_angle_rad", angle, "in [0, pi)");
}

void check_friction(const SlidingFrictionEffect& friction, Checker& check) {
  const std::string path = "effects.sliding_friction.";
  check.not_negative(path + "coefficient", friction.coefficient);
  check.positive(path + "stick_stiffness_n_per_m", friction.stick_stiffness_n_per_m);
  if (friction.normal_force_n) check.not_negative(path + "normal_force_n", *friction.normal_force_n);
}

void check_damping(const DampingEffect& damping, Checker& check) {
  const std::string path = "effects.damping.";
  check.not_negative(path + "stretch_ns", damping.stretch_ns);
  check.not_negative(path + "bending_nm2s", damping.bending_nm2s);
  check.not_negative(path + "wrapping_ns", damping.wrapping_ns);
  if (damping.sliding_ns_per_m) check.not_negative(path + "sliding_ns_per_m", *damping.sliding_ns_per_m);
}

void check_air_drag(const AirDragEffect& drag, Checker& check) {
  const std::string path = "effects.air_drag.";
  check.not_negative(path + "linear_ns_per_m2", drag.linear_ns_per_m2);
  if (drag.quadratic_ns2_per_m3) check.not_negative(path + "quadratic_ns2_per_m3", *drag.quadratic_ns2_per_m3);
}

void check_wind(const WindEffect& wind, Checker& check) {
  const std::string path = "effects.wind.";
  check.finite(path + "velocity_m_per_s", wind.velocity_m_per_s);
  check.finite(path + "gust_velocity_m_per_s", wind.gust_velocity_m_per_s);
  check.positive(path + "gust_period_s", wind.gust_period_s);
}

void check_shrinkage(const ShrinkageEffect& shrinkage, Checker& check) {
  const std::string path = "effects.shrinkage.keyframes";
  const std::vector<LengthKeyframe>& keys = shrinkage.keyframes;
  if (keys.empty()) check.fail(path, "none", "at least one keyframe");
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool later = i == 0 ? keys[0].t >= 0.0 : !std::isfinite(keys[i - 1].t) || keys[i].t > keys[i - 1].t;
    check.require(later, element(path, i) + ".t", keys[i].t,
                  i == 0 ? "a finite number >= 0" : "a finite number, greater than the one before");
    check.positive(element(path, i) + ".factor", keys[i].factor);
  }
}

void check_plasticity(const PlasticityEffect& plasticity, Checker& check) {
  check.not_negative("effects.plasticity.yield_angle_rad", plasticity.yield_angle_rad);
  check.positive("effects.plasticity.relaxation_time_s", plasticity.relaxation_time_s);
}

}  // namespace

void check_effects(const Effects& effects, Checker& check) {
  if (effects.inertia) {
    check.not_negative("effects.inertia.sliding_mass_fraction", effects.inertia->sliding_mass_fraction);
  }
  if (effects.gravity) check.finite("effects.gravity.acceleration_m_per_s2", effects.gravity->acceleration_m_per_s2);
  if (const auto& jamming = effects.bending_jamming) {
    const std::string path = "effects.bending_jamming.";
    check.require(jamming->max_factor >= 1.0, path + "max_factor", jamming->max_factor, "a finite number >= 1");
    check.require(jamming->full_at > 1.0, path + "full_at", jamming->full_at, "a finite number > 1");
  }
  if (effects.wrapping) check_wrapping(*effects.wrapping, check);
  if (effects.contact_length && effects.contact_length->stiffness_n) {
    check.positive("effects.contact_length.stiffness_n", *effects.contact_length->stiffness_n);
  }
  if (const auto& parallel = effects.parallel_contact) {
    const std::string path = "effects.parallel_contact.";
    if (parallel->stiffness_n_per_m2) check.positive(path + "stiffness_n_per_m2", *parallel->stiffness_n_per_m2);
    const double ratio = parallel->rest_ratio;
    check.require(ratio > 0.0 && ratio <= 1.0, path + "rest_ratio", ratio, "in (0, 1]");
  }
  if (effects.sliding_friction) check_friction(*effects.sliding_friction, check);
  if (effects.damping) check_damping(*effects.damping, check);
  if (effects.self_collision && effects.self_collision->stiffness_n) {
    check.positive("effects.self_collision.stiffness_n", *effects.self_collision->stiffness_n);
  }
  if (effects.colliders) check_colliders(*effects.colliders, effects.inertia || effects.automatic, check);
  if (effects.air_drag) check_air_drag(*effects.air_drag, check);
  if (effects.wind) check_wind(*effects.wind, check);
  if (effects.shrinkage) check_shrinkage(*effects.shrinkage, check);
  if (effects.plasticity) check_plasticity(*effects.plasticity, check);
  if (effects.automatic) {
    check_auto(*effects.automatic, check);  // and prerequisites come by themselves
  } else {
    check_prerequisites(effects, check);
  }
}

}  // namespace slipstitch
