// SPDX-License-Identifier: MIT
#include "scene_io/convert_parts.h"

namespace slipstitch {

std::vector<LengthKeyframe> length_keyframes_from(const LengthKeyframes& messages) {
  std::vector<LengthKeyframe> keyframes;
  for (const v1::LengthKeyframe& from : messages) {
    LengthKeyframe& keyframe = keyframes.emplace_back();
    keyframe.t = from.t();
    if (from.has_factor()) keyframe.factor = from.factor();
  }
  return keyframes;
}

void add_length_keyframes(const std::vector<LengthKeyframe>& keyframes, LengthKeyframes& messages) {
  for (const LengthKeyframe& keyframe : keyframes) {
    v1::LengthKeyframe& to = *messages.Add();
    to.set_t(keyframe.t);
    to.set_factor(keyframe.factor);
  }
}

namespace {

void read_effects_of_motion(const v1::Effects& message, Effects& effects, Issues& issues) {
  if (message.has_inertia()) {
    InertiaEffect& inertia = effects.inertia.emplace();
    if (message.inertia().has_sliding_mass_fraction()) {
      inertia.sliding_mass_fraction = message.inertia().sliding_mass_fraction();
    }
  }
  if (message.has_gravity()) {
    GravityEffect& gravity = effects.gravity.emplace();
    gravity.acceleration_m_per_s2 =
        vector_from(message.gravity().acceleration_m_per_s2(), gravity.acceleration_m_per_s2,
                    "effects.gravity.acceleration_m_per_s2", issues);
  }
  if (message.has_damping()) {
    DampingEffect& damping = effects.damping.emplace();
    damping.stretch_ns = message.damping().stretch_ns();
    damping.bending_nm2s = message.damping().bending_nm2s();
    damping.wrapping_ns = message.damping().wrapping_ns();
    if (message.damping().has_sliding_ns_per_m()) damping.sliding_ns_per_m = message.damping().sliding_ns_per_m();
  }
}

void read_elastic_effects(const v1::Effects& message, Effects& effects) {
  if (message.has_stretch()) effects.stretch.emplace();
  if (message.has_shrinkage()) {
    effects.shrinkage.emplace().keyframes = length_keyframes_from(message.shrinkage().keyframes());
  }
  if (message.has_bending()) effects.bending.emplace();
  if (message.has_plasticity()) {
    const v1::PlasticityEffect& from = message.plasticity();
    PlasticityEffect& plasticity = effects.plasticity.emplace();
    if (from.has_yield_angle_rad()) plasticity.yield_angle_rad = from.yield_angle_rad();
    if (from.has_relaxation_time_s()) plasticity.relaxation_time_s = from.relaxation_time_s();
  }
  if (message.has_bending_jamming()) {
    BendingJammingEffect& jamming = effects.bending_jamming.emplace();
    if (message.bending_jamming().has_max_factor()) jamming.max_factor = message.bending_jamming().max_factor();
    if (message.bending_jamming().has_full_at()) jamming.full_at = message.bending_jamming().full_at();
  }
  if (message.has_wrapping()) {
    WrappingEffect& wrapping = effects.wrapping.emplace();
    if (message.wrapping().has_alpha()) wrapping.alpha = message.wrapping().alpha();
    if (message.wrapping().has_stiffness_n()) wrapping.stiffness_n = message.wrapping().stiffness_n();
    if (message.wrapping().has_rest_angle_rad()) wrapping.rest_angle_rad = message.wrapping().rest_angle_rad();
  }
}

void read_sliding_effects(const v1::Effects& message, Effects& effects) {
  if (message.has_sliding()) effects.sliding.emplace();
  if (message.has_contact_length()) {
    ContactLengthEffect& length = effects.contact_length.emplace();
    if (message.contact_length().has_stiffness_n()) length.stiffness_n = message.contact_length().stiffness_n();
  }
  if (message.has_parallel_contact()) {
    const v1::ParallelContactEffect& from = message.parallel_contact();
    ParallelContactEffect& contact = effects.parallel_contact.emplace();
    if (from.has_stiffness_n_per_m2()) contact.stiffness_n_per_m2 = from.stiffness_n_per_m2();
    if (from.has_rest_ratio()) contact.rest_ratio = from.rest_ratio();
  }
  if (message.has_sliding_friction()) {
    const v1::SlidingFrictionEffect& from = message.sliding_friction();
    SlidingFrictionEffect& friction = effects.sliding_friction.emplace();
    if (from.has_coefficient()) friction.coefficient = from.coefficient();
    if (from.has_stick_stiffness_n_per_m()) friction.stick_stiffness_n_per_m = from.stick_stiffness_n_per_m();
    if (from.has_normal_force_n()) friction.normal_force_n = from.normal_force_n();
  }
}

void read_surroundings(const v1::Effects& message, Effects& effects, Issues& issues) {
  if (message.has_air_drag()) {
    AirDragEffect& drag = effects.air_drag.emplace();
    drag.linear_ns_per_m2 = message.air_drag().linear_ns_per_m2();
    if (message.air_drag().has_quadratic_ns2_per_m3()) {
      drag.quadratic_ns2_per_m3 = message.air_drag().quadratic_ns2_per_m3();
    }
  }
  if (message.has_wind()) {
    const v1::WindEffect& from = message.wind();
    const std::string path = "effects.wind.";
    WindEffect& wind = effects.wind.emplace();
    wind.velocity_m_per_s =
        vector_from(from.velocity_m_per_s(), wind.velocity_m_per_s, path + "velocity_m_per_s", issues);
    wind.gust_velocity_m_per_s =
        vector_from(from.gust_velocity_m_per_s(), wind.gust_velocity_m_per_s, path + "gust_velocity_m_per_s", issues);
    if (from.has_gust_period_s()) wind.gust_period_s = from.gust_period_s();
  }
}

void write_surroundings(const Effects& effects, v1::Effects& message) {
  if (effects.air_drag) {
    v1::AirDragEffect& drag = *message.mutable_air_drag();
    drag.set_linear_ns_per_m2(effects.air_drag->linear_ns_per_m2);
    if (effects.air_drag->quadratic_ns2_per_m3) drag.set_quadratic_ns2_per_m3(*effects.air_drag->quadratic_ns2_per_m3);
  }
  if (effects.wind) {
    v1::WindEffect& wind = *message.mutable_wind();
    add_vector(effects.wind->velocity_m_per_s, *wind.mutable_velocity_m_per_s());
    add_vector(effects.wind->gust_velocity_m_per_s, *wind.mutable_gust_velocity_m_per_s());
    wind.set_gust_period_s(effects.wind->gust_period_s);
  }
}

void write_effects_of_motion(const Effects& effects, v1::Effects& message) {
  if (effects.inertia) message.mutable_inertia()->set_sliding_mass_fraction(effects.inertia->sliding_mass_fraction);
  if (effects.gravity) {
    add_vector(effects.gravity->acceleration_m_per_s2, *message.mutable_gravity()->mutable_acceleration_m_per_s2());
  }
  if (effects.damping) {
    v1::DampingEffect& damping = *message.mutable_damping();
    damping.set_stretch_ns(effects.damping->stretch_ns);
    damping.set_bending_nm2s(effects.damping->bending_nm2s);
    damping.set_wrapping_ns(effects.damping->wrapping_ns);
    if (effects.damping->sliding_ns_per_m) damping.set_sliding_ns_per_m(*effects.damping->sliding_ns_per_m);
  }
}

void write_elastic_effects(const Effects& effects, v1::Effects& message) {
  if (effects.stretch) message.mutable_stretch();
  if (effects.shrinkage) {
    add_length_keyframes(effects.shrinkage->keyframes, *message.mutable_shrinkage()->mutable_keyframes());
  }
  if (effects.bending) message.mutable_bending();
  if (effects.plasticity) {
    message.mutable_plasticity()->set_yield_angle_rad(effects.plasticity->yield_angle_rad);
    message.mutable_plasticity()->set_relaxation_time_s(effects.plasticity->relaxation_time_s);
  }
  if (effects.bending_jamming) {
    message.mutable_bending_jamming()->set_max_factor(effects.bending_jamming->max_factor);
    message.mutable_bending_jamming()->set_full_at(effects.bending_jamming->full_at);
  }
  if (effects.wrapping) {
    v1::WrappingEffect& wrapping = *message.mutable_wrapping();
    wrapping.set_alpha(effects.wrapping->alpha);
    if (effects.wrapping->stiffness_n) wrapping.set_stiffness_n(*effects.wrapping->stiffness_n);
    wrapping.set_rest_angle_rad(effects.wrapping->rest_angle_rad);
  }
}

void write_sliding_effects(const Effects& effects, v1::Effects& message) {
  if (effects.sliding) message.mutable_sliding();
  if (effects.contact_length) {
    v1::ContactLengthEffect& length = *message.mutable_contact_length();
    if (effects.contact_length->stiffness_n) length.set_stiffness_n(*effects.contact_length->stiffness_n);
  }
  if (effects.parallel_contact) {
    v1::ParallelContactEffect& contact = *message.mutable_parallel_contact();
    const std::optional<double>& stiffness = effects.parallel_contact->stiffness_n_per_m2;
    if (stiffness) contact.set_stiffness_n_per_m2(*stiffness);
    contact.set_rest_ratio(effects.parallel_contact->rest_ratio);
  }
  if (effects.sliding_friction) {
    v1::SlidingFrictionEffect& friction = *message.mutable_sliding_friction();
    friction.set_coefficient(effects.sliding_friction->coefficient);
    friction.set_stick_stiffness_n_per_m(effects.sliding_friction->stick_stiffness_n_per_m);
    if (effects.sliding_friction->normal_force_n) {
      friction.set_normal_force_n(*effects.sliding_friction->normal_force_n);
    }
  }
}

}  // namespace

Effects effects_from_message(const v1::Effects& message, Issues& issues) {
  Effects effects;
  if (message.has_auto_()) {
    AutoEffects& automatic = effects.automatic.emplace();
    if (message.auto_().has_tolerance_m()) automatic.tolerance_m = message.auto_().tolerance_m();
    if (message.auto_().has_window_s()) automatic.window_s = message.auto_().window_s();
  }
  read_effects_of_motion(message, effects, issues);
  read_elastic_effects(message, effects);
  read_sliding_effects(message, effects);
  if (message.has_self_collision()) {
    effects.self_collision.emplace();
    if (message.self_collision().has_stiffness_n()) effects.self_collision->stiffness_n = message.self_collision().stiffness_n();
  }
  if (message.has_colliders()) effects.colliders = colliders_from(message.colliders(), issues);
  read_surroundings(message, effects, issues);
  return effects;
}

void write_effects(const Effects& effects, v1::Effects& message) {
  if (const auto& automatic = effects.automatic) {
    v1::AutoEffects& to = *message.mutable_auto_();
    if (automatic->tolerance_m) to.set_tolerance_m(*automatic->tolerance_m);
    if (automatic->window_s) to.set_window_s(*automatic->window_s);
  }
  write_effects_of_motion(effects, message);
  write_elastic_effects(effects, message);
  write_sliding_effects(effects, message);
  if (effects.self_collision) {
    message.mutable_self_collision();
    if (effects.self_collision->stiffness_n) message.mutable_self_collision()->set_stiffness_n(*effects.self_collision->stiffness_n);
  }
  if (effects.colliders) write_colliders(*effects.colliders, *message.mutable_colliders());
  write_surroundings(effects, message);
}

}  // namespace slipstitch
