// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// How much of a wrap acts where its triangles degenerate and psi loses its meaning: where a yarn runs nearly straight
/// through the contact, or one of the edges axis = x1 - x0, a = x4 - x0, b = x3 - x1 has nearly no length:
///   S(sin(axis, a)/0.3) S(sin(axis, b)/0.3) S(1000 |axis|/L) S(1000 |a|/L) S(1000 |b|/L),
/// S the C2 smoothstep, L [m] the contact's rest length. Exactly 1 where no argument is below 1, exactly 0 where a sine
/// is below 1e-9 or a length below 1e-9 of L/1000.
inline constexpr double kWrapFadeSine = 0.3;
inline constexpr double kWrapFadeLength = 1e-3;
inline constexpr double kWrapGone = 1e-9;

double wrap_fade(const Vec<12>& q, double L);

/// The fade; first and second derivative where non-null. Order x0, x1, x3, x4.
double wrap_fade_derivatives(const Vec<12>& q, double L, Vec<12>* g, Mat<12>* hess);

}  // namespace slipstitch
