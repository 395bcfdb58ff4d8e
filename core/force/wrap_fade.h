// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// How much of a wrap acts where a yarn runs nearly straight through the contact and psi loses its meaning:
///   S(sin a / 0.3) S(sin b / 0.3), a = angle(e, x4 - x0), b = angle(e, x3 - x1), S the C2 smoothstep.
/// Exactly 1 where both sines are >= 0.3, exactly 0 where one is below 1e-9 or an edge has no length.
inline constexpr double kWrapFadeSine = 0.3;
inline constexpr double kWrapGoneSine = 1e-9;

double wrap_fade(const Vec3& x0, const Vec3& x1, const Vec3& x3, const Vec3& x4);

/// The fade; first and second derivative where non-null. Order x0, x1, x3, x4.
double wrap_fade_derivatives(const Vec<12>& q, Vec<12>* g, Mat<12>* hess);

}  // namespace slipstitch
