// SPDX-License-Identifier: MIT
#pragma once

#include "force/wrapping.h"
#include "gauntlet/high_precision.h"

namespace slipstitch::testing {

/// A hinge x0, x1, x3, x4 in units of the contact's rest length: its axis of length `axis` along x, x4 at height
/// `height_a` above its foot on the axis' line, x3 likewise, turned by psi.
struct Hinge {
  double height_a = 0.8, height_b = 0.8, foot_a = 0.4, foot_b = 0.7, axis = 1.0;

  Vec<12> at(double psi) const;
  Vec<12> turned(double psi) const;  // and in no special direction
};

inline constexpr double kRestLength = 1e-3;  // L [m]

/// psi, and the energy in use, written down once more from their definitions.
Real real_wrap_angle(const Reals& q);
Real real_wrapping_energy(const Wrap& wrap, double offset, const Reals& q);

}  // namespace slipstitch::testing
