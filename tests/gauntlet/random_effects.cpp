// SPDX-License-Identifier: MIT
// Which effects a random scene lists, and with what.
#include <algorithm>

#include "gauntlet/random_parts.h"
#include "model/effect_list.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kUsualStretch = YarnMaterial{}.stretch_n;

double random_friction(Dice& dice) { return dice.chance(0.15) ? 0.0 : dice.log_uniform(0.01, 10.0); }

void add_gravity(Draft& draft) {
  const Vec3 way = draft.dice.chance(0.5) ? Vec3(-Vec3::UnitY()) : draft.dice.direction();
  // Many radii a step: a long fall within one.
  const double most = 200.0 * draft.radius_a_step() / draft.step_s;
  const double size = std::min(9.81 * draft.dice.log_uniform(0.1, 30.0), most);
  draft.scene.effects.gravity = GravityEffect{size * way};
}

void add_bends(Draft& draft) {
  Dice& dice = draft.dice;
  Effects& on = draft.scene.effects;
  if (dice.chance(0.4))
    on.bending_jamming = BendingJammingEffect{dice.log_uniform(2.0, 3000.0), dice.uniform(1.2, 3.0)};
  if (!dice.chance(0.25)) return;
  on.plasticity = PlasticityEffect{dice.uniform(0.0, 1.5), draft.duration_s() * dice.log_uniform(0.05, 5.0)};
}

void add_wrapping(Draft& draft) {
  Dice& dice = draft.dice;
  WrappingEffect& wrapping = draft.scene.effects.wrapping.emplace();
  wrapping.alpha = dice.chance(0.1) ? 0.0 : dice.log_uniform(0.01, 1.0);
  const YarnMaterial& yarn = draft.scene.yarn;
  if (dice.chance(0.2))
    wrapping.stiffness_n = yarn.bending_nm2 / (yarn.radius_m * yarn.radius_m) * dice.log_uniform(1e-3, 0.1);
  if (dice.chance(0.3)) wrapping.rest_angle_rad = dice.uniform(0.5, 2.2);
}

void add_sliding(Draft& draft) {
  Dice& dice = draft.dice;
  Effects& on = draft.scene.effects;
  const YarnMaterial& yarn = draft.scene.yarn;
  on.sliding.emplace();
  // Without these two, bends push the yarn out of contacts and of the ways between them until none is left there.
  on.contact_length.emplace();
  if (dice.chance(0.2)) on.contact_length->stiffness_n = yarn.stretch_n * dice.log_uniform(0.1, 3.0);
  on.parallel_contact.emplace().rest_ratio = dice.uniform(0.3, 1.0);
  if (dice.chance(0.2))
    on.parallel_contact->stiffness_n_per_m2 =
        yarn.stretch_n / (yarn.radius_m * yarn.radius_m) * dice.log_uniform(0.03, 1.0);
  if (!dice.chance(0.8)) return;
  SlidingFrictionEffect& friction = on.sliding_friction.emplace();
  friction.coefficient = random_friction(dice);
  friction.stick_stiffness_n_per_m *= yarn.stretch_n / kUsualStretch * dice.log_uniform(0.1, 10.0);
  if (dice.chance(0.2)) friction.normal_force_n = yarn.stretch_n * dice.log_uniform(1e-6, 1e-3);
}

void add_damping(Draft& draft) {
  Dice& dice = draft.dice;
  const YarnMaterial& yarn = draft.scene.yarn;
  DampingEffect& damping = draft.scene.effects.damping.emplace();
  if (dice.chance(0.3)) damping.stretch_ns = yarn.stretch_n * dice.log_uniform(1e-6, 1e-3);
  if (dice.chance(0.8)) damping.bending_nm2s = yarn.bending_nm2 * dice.log_uniform(1e-3, 1.0);
  if (dice.chance(0.8))
    damping.wrapping_ns = yarn.bending_nm2 / (yarn.radius_m * yarn.radius_m) * dice.log_uniform(1e-4, 0.1);
  if (draft.scene.effects.sliding && dice.chance(0.8))
    damping.sliding_ns_per_m = yarn.radius_m / YarnMaterial{}.radius_m * dice.log_uniform(1e-4, 100.0);
}

void add_air(Draft& draft) {
  Dice& dice = draft.dice;
  Effects& on = draft.scene.effects;
  AirDragEffect& drag = on.air_drag.emplace();
  if (dice.chance(0.5)) drag.linear_ns_per_m2 = dice.log_uniform(1e-5, 1e-1);
  if (dice.chance(0.3)) drag.quadratic_ns2_per_m3 = draft.radius() * dice.log_uniform(0.1, 10.0);
  if (!dice.chance(0.6)) return;
  WindEffect& wind = on.wind.emplace();
  wind.velocity_m_per_s = dice.log_uniform(0.05, 20.0) * dice.direction();
  if (dice.chance(0.5)) wind.gust_velocity_m_per_s = dice.log_uniform(0.05, 10.0) * dice.direction();
  wind.gust_period_s = draft.step_s * dice.log_uniform(1.5, 50.0);
}

void add_shrinkage(Draft& draft) {
  ShrinkageEffect& shrinkage = draft.scene.effects.shrinkage.emplace();
  const int keys = draft.dice.between(1, 3);
  for (int k = 1; k <= keys; ++k)
    shrinkage.keyframes.push_back({draft.duration_s() * k / (keys + 1), draft.dice.uniform(0.8, 1.15)});
}

}  // namespace

void draw_effects(Draft& draft) {
  Dice& dice = draft.dice;
  Effects& on = draft.scene.effects;
  on.stretch.emplace();  // without it nothing says how long yarn is
  if (dice.chance(0.85)) on.inertia.emplace();
  if (draft.moves() && dice.chance(0.3)) on.inertia->sliding_mass_fraction = dice.log_uniform(1e-6, 1e-2);
  if (!draft.moves() || dice.chance(0.92)) on.bending.emplace();  // at rest, chains of hinges have no shape
  if (on.bending) add_bends(draft);
  if (dice.chance(0.7)) add_gravity(draft);
  if (dice.chance(0.85)) add_wrapping(draft);
  if (dice.chance(0.8)) add_sliding(draft);
  if (dice.chance(0.85)) add_damping(draft);
  if (dice.chance(0.3)) on.self_collision.emplace();
  if (on.self_collision && dice.chance(0.2))
    on.self_collision->stiffness_n = draft.scene.yarn.stretch_n * dice.log_uniform(1e-4, 1e-2);
  if (draft.moves() && dice.chance(0.35)) add_air(draft);
  if (dice.chance(0.2)) add_shrinkage(draft);
  // A force that all stiffnesses here leave to round-off.
  auto& numerics = std::get<FixedNumerics>(draft.scene.numerics);
  numerics.force_tolerance_n *= std::max(1.0, draft.scene.yarn.stretch_n / kUsualStretch);
  if (!draft.moves()) numerics.max_newton_iterations = 500;  // a shorter step is no easier then
}

}  // namespace slipstitch::gauntlet
