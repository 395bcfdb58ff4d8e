// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sim/simulation.h"

namespace slipstitch {

/// Where a connected piece of fabric can be: within `radius` of one of the anchors, which move as one. Where nobody can
/// tell how they move, as in air, the radius grows by speed t + gain t^2 / 2.
struct ReachPart {
  std::vector<Vec3> anchors;         // [m] at t = 0
  bool held = false;                 // by handles that stand still; otherwise it falls freely
  Vec3 velocity = Vec3::Zero();      // of the anchors at t = 0 [m/s]
  Vec3 acceleration = Vec3::Zero();  // of the anchors [m/s^2]
  double radius = 0.0;               // [m], the yarn's own included
  double speed = 0.0, gain = 0.0;    // [m/s], [m/s^2]
};

/// A bound over the whole run on where the fabric can be, as long as it touches no body.
struct Reach {
  std::string no_bound;  // why there is none; empty: there is one
  std::vector<ReachPart> parts;
  Vec3 gravity = Vec3::Zero();  // by which dynamic spheres fall, that touch nothing [m/s^2]
};

struct RunSpan {
  double duration_s = 0.0, step_s = 0.0;  // step: the largest
  bool may_add_energy = false;            // a step of implicit Euler, or to rest, ends no higher than it began
};

/// From the energy that there is, at the start and from weight and loads, every other term taking some: a path of yarn
/// of rest length S that is strained to r holds EA (r - S)^2/(2 S) at least, and neither implicit Euler nor a way to
/// rest adds energy. A part that is held stays within a path of its held nodes; one that is free stays within a path of
/// its centre of mass, which falls freely. Where yarn slides a path can take in all yarn of its part, so the bound is
/// wide. There is none where something does work that cannot be told before: moving handles, wind, shrinkage; nor for a
/// free part with loads or without inertia; nor for parts that can push each other; nor without stretch; nor with an
/// integrator that may add energy.
Reach bound_reach(Simulation& sim, const RunSpan& span);

RunSpan span_of(const Scene& scene);

/// Where it can be if no yarn is ever twice as long as it is at rest, whatever work is done. None without stretch, with
/// shrinkage, or for a free part that wind, loads or other parts move or that has no inertia.
Reach reach_at_twice_its_length(Simulation& sim, const RunSpan& span);

/// Whether a body stays outside of the reach for the whole duration; false where that cannot be shown.
bool stays_out_of_reach(const Reach& reach, const Collider& collider, const RunSpan& span);

/// Indices of the colliders of the model that are never reached. None where another may be reached that moves, or that
/// a free part bounces off, as the reach holds up to that touch only.
std::vector<int> colliders_out_of_reach(const Simulation& sim, const Reach& reach, const RunSpan& span);

}  // namespace slipstitch
