// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// Stick-slip of a point x on a surface: with s the part of x - anchor along it,
/// V = 1/2 k |s|^2 while k |s| <= limit, else limit |s| - limit^2 / (2 k). C1 and convex; k [N/m] > 0, limit [N] >= 0.
struct StickSlip {
  Vec3 anchor = Vec3::Zero(), normal = Vec3::UnitY();
  double k = 0.0, limit = 0.0;

  struct Pull {
    double value = 0.0;  // V
    double force_over_way = 0.0;
    Vec3 way = Vec3::Zero();        // s; dV/dx = force_over_way s
    Mat3 stiffness = Mat3::Zero();  // d2V/dx2
  };
  Pull pull(const Vec3& x) const;

  /// The anchor once x has come to rest: dragged behind a point that has slipped.
  Vec3 dragged(const Vec3& x) const;
};

}  // namespace slipstitch
