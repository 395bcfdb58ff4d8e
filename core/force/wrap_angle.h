// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// The signed angle psi between the triangles (x0, x1, x4) and (x0, x3, x1) about the axis e = (x1 - x0)/|x1 - x0|:
///   psi = atan2(e.(na x nb), na.nb) in (-pi, pi],  va = (x4 - x1) x (x0 - x1),  vb = (x0 - x1) x (x3 - x1).
/// 0: unwrapped, in one plane on opposite sides of the axis; +-pi: folded onto each other. Positive where x3 dips
/// below the plane of the a side, seen from na. Swapping x0 with x1 or x3 with x4 flips the sign, swapping both keeps
/// it. Where x4 or x3 lies on the axis psi means nothing; it is 0 where a
/// triangle has exactly no area. The angle is signed, so that the derivatives hold in every pose,
/// unlike the arccos of [Cirio et al. 2015, supplement eq. 7]. Order x0, x1, x3, x4.
double wrap_angle(const Vec3& x0, const Vec3& x1, const Vec3& x3, const Vec3& x4);

/// psi; d psi/dx and d2 psi/dx2 where non-null. [Cirio et al. 2015, supplement eqs. 8, 11, with (I - 2nn^T)x^* written
/// as outer products]
double wrap_angle_derivatives(const Vec<12>& q, Vec<12>* g, Mat<12>* hess);

}  // namespace slipstitch
