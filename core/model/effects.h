// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "math/types.h"
#include "model/collider.h"

namespace slipstitch {

/// What a scene simulates. An effect that is not engaged here is not built: no stencils, no unknowns, no cost.
/// Symbols as in core/README.md.

/// Consistent Eulerian-on-Lagrangian mass. Off: every step is quasi-static.
struct InertiaEffect {
  double sliding_mass_fraction = 1e-6;  // m_u = fraction * rho * rest segment length [kg] on every free arc length, >= 0
};

struct GravityEffect {
  Vec3 acceleration_m_per_s2{0.0, -9.81, 0.0};
};

struct StretchEffect {};  // k_s from the yarn

struct BendingEffect {};  // k_b from the yarn, rest angle 0

/// Raises k_b from x1 to x max_factor while the curvature 2 theta/W grows from kappa_j = pi/W_rest to
/// full_at * kappa_j (C2 smoothstep of log k_b). Needs bending.
struct BendingJammingEffect {
  double max_factor = 1000.0;  // >= 1
  double full_at = 2.0;        // > 1
};

/// V = 1/2 k_w L t(psi - s psi0)^2 on both diagonals of every stitch contact.
struct WrappingEffect {
  double alpha = 1.0;                 // k_w = alpha EI / L^2, >= 0; used when stiffness_n is absent. Curl and ribs
                                      // of tests/knit hold at 1; at 0.4 a free 1x1 rib is 0.8 of stockinette's width
  std::optional<double> stiffness_n;  // k_w per diagonal [N], >= 0
  double rest_angle_rad = kPi / 2;    // psi0, in [0, pi)
};

/// V = 1/2 k_l L (l/L - 1)^2 on both arc lengths of every stitch contact. Needs sliding.
struct ContactLengthEffect {
  std::optional<double> stiffness_n;  // k_l [N] > 0; default EA
};

/// V = 1/2 k_c L (du - d)^2 where du < d, on free segments between contacts of one yarn; d = min(2R, ratio * rest du).
/// Needs sliding.
struct ParallelContactEffect {
  std::optional<double> stiffness_n_per_m2;  // k_c > 0; default EA / (2R)^2
  double rest_ratio = 0.7;                   // in (0, 1]
};

/// Arc lengths of contact and guide nodes become unknowns. Off: 3 unknowns a node.
struct SlidingEffect {};

/// Anchored-spring stick-slip on every sliding coordinate. Needs sliding.
struct SlidingFrictionEffect {
  double coefficient = 0.3;              // mu >= 0
  double stick_stiffness_n_per_m = 100;  // k_f > 0
  std::optional<double> normal_force_n;  // given F_n >= 0; default: estimated from the yarns' tension and bending
};

/// Viscous, 1/2 eta rate^2: rigid motion is undamped.
struct DampingEffect {
  double stretch_ns = 0.0;         // eta of the stretch rate [N s], >= 0
  double bending_nm2s = 0.0;       // eta of theta [N m^2 s], >= 0
  double wrapping_ns = 0.0;        // eta of psi [N s], >= 0
  std::optional<double> sliding_ns_per_m;  // d_f on every sliding coordinate [N s/m], >= 0; needs sliding. Default there:
  static constexpr double kDefaultSliding = 1e-3;
};

/// Rigid bodies that yarn touches but does not enter, with stick-slip friction.
struct CollidersEffect {
  std::vector<Collider> colliders;
  std::optional<double> stiffness_n;      // of the contact, k of gap_energy() > 0; default EA / 1000
  double stick_stiffness_n_per_m = 100;   // k_t of each touching point > 0
};

/// Drag of the air on every segment, (c1 + c2 |w|) w per metre against its velocity w through the air. Needs inertia.
struct AirDragEffect {
  double linear_ns_per_m2 = 0.0;               // c1 >= 0
  std::optional<double> quadratic_ns2_per_m3;  // c2 >= 0; default 1/2 rho C_d 2R, rho = 1.2 kg/m^3, C_d = 1.2
};

/// Velocity of the air, velocity + gust sin(2 pi t/period). Needs air_drag.
struct WindEffect {
  Vec3 velocity_m_per_s = Vec3::Zero();
  Vec3 gust_velocity_m_per_s = Vec3::Zero();
  double gust_period_s = 1.0;  // > 0
};

/// Rest length of yarn over its arc length at a time.
struct LengthKeyframe {
  double t = 0.0;       // [s] >= 0, strictly increasing
  double factor = 1.0;  // > 0
};

/// Yarn that changes its length, as in blocking and fulling: stretch is measured against factor * arc length. Linear
/// between keyframes and from 1 at t = 0, held after the last. Needs stretch.
struct ShrinkageEffect {
  std::vector<LengthKeyframe> keyframes;  // >= 1
};

/// Bends that keep a set: the angle at rest of a bend, 0 at the start, creeps after the bend angle beyond a yield angle.
/// It stays with the node, also where the yarn slides, and has no direction. Needs bending.
struct PlasticityEffect {
  double yield_angle_rad = 0.5;    // elastic part of a bend angle that it bears for ever [rad], >= 0
  double relaxation_time_s = 1.0;  // of what is beyond, > 0
};

/// Yarn that touches other parts of the fabric but does not pass through them.
struct SelfCollisionEffect {
  std::optional<double> stiffness_n;  // k of gap_energy() of two points > 0; default EA / 1000
};

/// Which effects, of those listed and those with defaults, matter here is found before the run (study/choose_effects.h).
struct AutoEffects {
  std::optional<double> tolerance_m;  // a difference of positions that does not matter > 0; default: effects.proto
  std::optional<double> window_s;     // simulated to find out > 0; default: effects.proto
};

struct Effects {
  std::optional<AutoEffects> automatic;  // "auto" in the schema
  std::optional<InertiaEffect> inertia;
  std::optional<GravityEffect> gravity;
  std::optional<StretchEffect> stretch;
  std::optional<BendingEffect> bending;
  std::optional<BendingJammingEffect> bending_jamming;
  std::optional<WrappingEffect> wrapping;
  std::optional<ContactLengthEffect> contact_length;
  std::optional<ParallelContactEffect> parallel_contact;
  std::optional<SlidingEffect> sliding;
  std::optional<SlidingFrictionEffect> sliding_friction;
  std::optional<DampingEffect> damping;
  std::optional<CollidersEffect> colliders;
  std::optional<SelfCollisionEffect> self_collision;
  std::optional<AirDragEffect> air_drag;
  std::optional<WindEffect> wind;
  std::optional<ShrinkageEffect> shrinkage;
  std::optional<PlasticityEffect> plasticity;
};

}  // namespace slipstitch
