// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// Signed distance to a surface, negative inside: phi with its gradient, the outward unit normal, and its Hessian.
struct Distance {
  double phi = 0.0;  // [m]
  Vec3 normal = Vec3::UnitY();
  Mat3 curvature = Mat3::Zero();  // d2 phi / dp2 [1/m]
};

}  // namespace slipstitch
