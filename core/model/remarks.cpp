// SPDX-License-Identifier: MIT
#include "model/remarks.h"

#include <algorithm>

#include "model/effect_list.h"
#include "model/pieces.h"

namespace slipstitch {
namespace {

constexpr std::size_t kPointsToMeetItself = 5;  // segments with one between them are neighbours
constexpr double kAlphaThatRollsUp = 0.3;  // free edges of stockinette at this wrapping stiffness close into a scroll

bool moves(const Handle& handle) { return !handle.motion.empty() || handle.velocity_m_per_s.has_value(); }

bool moves(const Collider& collider) {
  return !collider.motion.empty() || (collider.dynamic && !collider.dynamic->velocity_m_per_s.isZero(0.0));
}

bool has_moving_collider(const Scene& scene) {
  const auto& effect = scene.effects.colliders;
  return effect && std::any_of(effect->colliders.begin(), effect->colliders.end(),
                               [](const Collider& collider) { return moves(collider); });
}

bool is_straight(const BareYarn& yarn) {
  const Vec3 along = (yarn.points.back() - yarn.points.front()).normalized();
  return std::all_of(yarn.points.begin(), yarn.points.end(), [&](const Vec3& p) {
    const Vec3 from = p - yarn.points.front();
    return from.cross(along).norm() <= 1e-9 * from.norm();
  });
}

/// Nothing in it wants to be longer, shorter or straighter. Lengths that are given are taken to want so.
bool is_relaxed(const BareYarn& yarn, const Effects& on) {
  return yarn.prestretch == 1.0 && yarn.arc_lengths_m.empty() && (!on.bending || is_straight(yarn));
}

bool at_rest_for_ever(const Scene& scene) {
  return !has_moving_collider(scene) && !scene.effects.gravity && !scene.effects.wind && !scene.effects.shrinkage &&
         scene.loads.empty() && scene.initial_velocities.empty() &&
         std::none_of(scene.handles.begin(), scene.handles.end(), [](const Handle& handle) { return moves(handle); }) &&
         std::none_of(scene.yarns.begin(), scene.yarns.end(), [&](const BareYarn& yarn) {
           return !is_relaxed(yarn, scene.effects) || !yarn.velocity_m_per_s.isZero(0.0);
         });
}

bool is_idle(const std::vector<IdleEffect>& effects, std::string_view name) {
  return std::any_of(effects.begin(), effects.end(), [&](const IdleEffect& idle) { return idle.effect == name; });
}

/// What needs an effect that cannot matter cannot matter either.
void add_what_needs_them(const Effects& on, std::vector<IdleEffect>& effects) {
  for (const EffectEntry& effect : effect_list())
    if (effect.listed(on) && !is_idle(effects, effect.name) && is_idle(effects, effect.needs))
      effects.push_back({effect.name, std::string("it needs ") + effect.needs + ", which cannot matter"});
}

}  // namespace

std::vector<IdleEffect> idle_effects(const Scene& scene) {
  const Effects& on = scene.effects;
  std::vector<IdleEffect> effects;
  const auto idle = [&](bool holds, const char* effect, const char* why) {
    if (holds) effects.push_back({effect, why});
  };
  const bool stitches = scene.knit.has_value(), shared = stitches || !scene.crossings.empty();
  const bool no_bends = !stitches && std::all_of(scene.yarns.begin(), scene.yarns.end(),
                                                 [](const BareYarn& yarn) { return yarn.points.size() < 3; });
  const bool no_air = on.air_drag && on.air_drag->linear_ns_per_m2 == 0.0 && on.air_drag->quadratic_ns2_per_m3 == 0.0;
  idle(on.gravity && on.gravity->acceleration_m_per_s2.isZero(0.0), "gravity", "its acceleration is 0");
  idle(on.wrapping && !stitches, "wrapping", "only stitches wrap, and the scene has no knit");
  idle(on.wrapping && stitches && on.wrapping->stiffness_n.value_or(on.wrapping->alpha) == 0.0, "wrapping",
       "its stiffness is 0");
  idle(on.contact_length && !stitches, "contact_length",
       "only stitches have contacts of a length, and the scene has no knit");
  idle(on.sliding && !shared && scene.guides.empty(), "sliding", "no yarn passes a stitch, a crossing or a guide");
  idle(on.sliding_friction && on.sliding_friction->coefficient == 0.0, "sliding_friction", "its coefficient is 0");
  idle(on.sliding_friction && on.sliding_friction->normal_force_n == 0.0, "sliding_friction", "its normal force is 0");
  idle(on.bending_jamming && on.bending_jamming->max_factor == 1.0, "bending_jamming", "its max_factor is 1");
  idle(on.damping && on.damping->stretch_ns == 0.0 && on.damping->bending_nm2s == 0.0 &&
           (on.damping->wrapping_ns == 0.0 || !on.wrapping || !stitches) && (on.damping->sliding_ns_per_m == 0.0 || !on.sliding),
       "damping", "it damps nothing that moves");
  const char* const straight = "yarns of one segment cannot bend";
  idle(on.bending && no_bends, "bending", straight);
  idle(on.bending_jamming && no_bends, "bending_jamming", straight);
  idle(on.plasticity && no_bends, "plasticity", straight);
  idle(on.plasticity && on.plasticity->yield_angle_rad >= kPi, "plasticity", "no bend angle exceeds pi");
  idle(on.self_collision && !stitches && scene.yarns.size() == 1 && scene.yarns[0].points.size() < kPointsToMeetItself,
       "self_collision", "a yarn of fewer than four segments cannot meet itself");
  idle(no_air, "air_drag", "both its coefficients are 0");
  idle(on.wind && no_air, "wind", "both coefficients of air_drag are 0");
  idle(on.wind && on.wind->velocity_m_per_s.isZero(0.0) && on.wind->gust_velocity_m_per_s.isZero(0.0), "wind",
       "the air stands still");
  idle(on.shrinkage && std::all_of(on.shrinkage->keyframes.begin(), on.shrinkage->keyframes.end(),
                                   [](const LengthKeyframe& key) { return key.factor == 1.0; }),
       "shrinkage", "every factor is 1");
  add_what_needs_them(on, effects);
  return effects;
}

namespace {

void add_missing(const Scene& scene, std::vector<std::string>& remarks) {
  const Effects& on = scene.effects;
  const auto missing = [&](bool holds, const char* effect, const char* why) {
    if (holds) remarks.push_back(std::string("effects.") + effect + " is probably missing: " + why);
  };
  missing(!on.stretch, "stretch", "without it yarn has no length to keep");
  missing(scene.knit && !on.bending, "bending", "without it a stitch has no shape to keep");
  missing(scene.knit && on.bending && !on.wrapping, "wrapping",
          "without it nothing holds the loops of a stitch around each other, and no edge curls");
  const std::vector<Piece> pieces = pieces_of(scene);
  const auto falls = std::count_if(pieces.begin(), pieces.end(), [](const Piece& piece) { return !piece.held; });
  const bool all_fall = falls == static_cast<long>(pieces.size());
  const bool on_yarn = on.self_collision && !all_fall;
  const bool weight = on.gravity && !on.gravity->acceleration_m_per_s2.isZero(0.0);
  missing(!on.inertia && weight && !on.colliders && falls > 0 && !on_yarn, "inertia",
          "yarn that nothing holds falls, which is no equilibrium");
  missing(on.inertia && weight && !on.colliders && falls > 0 && !on_yarn, "colliders",
          all_fall ? "nothing is held, and the fabric falls onto nothing"
                   : "a piece of yarn that nothing holds falls onto nothing");
  missing(on.inertia && weight && !on.self_collision && falls > 0 && !all_fall, "self_collision",
          "a piece of yarn that nothing holds falls through the others, should any lie in its way");
  missing(on.inertia && !on.self_collision && pieces.size() > 1 &&
              std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.thrown; }),
          "self_collision", "yarn that is thrown passes through other yarn");
  missing(on.sliding && scene.knit && !on.parallel_contact, "parallel_contact",
          "yarn can slide until two contacts are in one place");
  missing(on.sliding && scene.knit && !on.contact_length, "contact_length",
          "the yarn inside a contact can slide out of it");
  missing(on.inertia && scene.knit && !on.damping && !on.air_drag, "damping",
          "without it the fabric swings for ever, but for what the time steps take");
  missing(scene.knit && on.wrapping && !on.self_collision && on.wrapping->alpha >= kAlphaThatRollsUp &&
              !on.wrapping->stiffness_n && scene.duration_s > 0.1,
          "self_collision", "free edges at this wrapping stiffness roll up, through themselves");
}

}  // namespace

std::vector<std::string> remarks_on(const Scene& scene) {
  std::vector<std::string> remarks;
  for (const IdleEffect& idle : idle_effects(scene))
    remarks.push_back("effects." + idle.effect + " cannot matter here: " + idle.why);
  if (scene.knit || !scene.yarns.empty()) add_missing(scene, remarks);
  if (!scene.knit && at_rest_for_ever(scene))
    remarks.push_back("handles, loads or effects.gravity are probably missing: nothing moves the yarn");
  return remarks;
}

}  // namespace slipstitch
