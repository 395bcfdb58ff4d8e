// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "collide/rigid_body.h"
#include "force/touch_samples.h"
#include "model/state.h"

namespace slipstitch {

inline constexpr double kTouchReach = 4.0;  // radii within which a point is watched, besides what it moves in a step
inline constexpr double kTouchReachOfMove = 1.5;  // of the way that its velocity takes it
inline constexpr double kTouchKeep = 0.1;         // share of the way to the deepest overlap that one Newton step leaves

/// What can touch what. Made once a model and shared by the terms; samples follow the yarn, bodies are at t = 0.
struct TouchParts {
  double radius = 0.0, depth = 0.0;  // of the yarn; deepest overlap of its points [m]
  double ball_depth = 0.0;           // with dynamic spheres, so much less that between points it is `depth` too [m]
  double k = 0.0;                    // of gap_energy() [N]
  double k_t = 0.0;                  // of a sticking point [N/m]
  TouchSamples samples;              // of the yarn, against `bodies`
  std::vector<RigidBody> bodies;     // the colliders that are not dynamic, in their order
  TouchSamples all_samples;          // against Model::bodies: closer, and on yarn that handles move too
};

using SharedTouchParts = std::shared_ptr<TouchParts>;

/// Empty lists where the scene has no such colliders.
SharedTouchParts touch_parts(const Model& model);

/// Touches stand in this order: ascending in sample, then body.
bool before(const Touch& a, const Touch& b);
/// The same samples and bodies.
bool same_pairs(const std::vector<Touch>& a, const std::vector<Touch>& b);

}  // namespace slipstitch
