// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "math/types.h"

namespace slipstitch {

class Simulation;

/// Where a dynamic collider is and how it moves.
struct BodyMotion {
  int collider = -1;                                                // into the scene's colliders
  Vec3 position_m = Vec3::Zero(), velocity_m_per_s = Vec3::Zero();  // of its centre
};

/// One a dynamic collider, in their order, at the last accepted step.
std::vector<BodyMotion> body_motions(const Simulation& sim);

}  // namespace slipstitch
