// SPDX-License-Identifier: MIT
#pragma once

#include "gauntlet/random_parts.h"

namespace slipstitch::gauntlet {

/// Straight ahead along one direction the fabric ends here.
struct Front {
  Vec3 way = Vec3::UnitX(), middle = Vec3::Zero();  // middle of the fabric
  double end = 0.0, size = 0.0;                     // most x.way of its nodes; how far it reaches from the middle [m]
};

Front front_of(const Model& model, const Vec3& way);

/// About the origin, no thinner than the yarn and no wider than the fabric; a plane faces against `way`.
Shape random_shape(Draft& draft, const Front& front);

/// The shape moved along the front's way until the first of its points is `ahead` [m] of the origin, then by `beside`.
Shape moved_ahead(Shape shape, const Front& front, double ahead, const Vec3& beside);

}  // namespace slipstitch::gauntlet
