// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "math/types.h"

namespace slipstitch {

struct Keyframe {
  double t = 0.0;                     // [s], strictly increasing
  Vec3 translation_m = Vec3::Zero();  // of the start position
  Vec3 rotation_rad = Vec3::Zero();   // axis * angle about the centre, applied before the translation
};

/// Linear in time between keyframes; before the first one from rest at t = 0, after the last one held.
Keyframe motion_at(const std::vector<Keyframe>& motion, double t);

/// The turn by an axis * angle.
Mat3 turn_by(const Vec3& rotation_rad);

}  // namespace slipstitch
