// SPDX-License-Identifier: MIT
#pragma once

#include "collide/distance.h"
#include "model/collider.h"

namespace slipstitch {

/// To shapes where they stand at t = 0. Inside, the nearest face of a box, and the exact distance of all others.
Distance distance_to(const Plane& plane, const Vec3& p);
Distance distance_to(const Sphere& sphere, const Vec3& p);
Distance distance_to(const Capsule& capsule, const Vec3& p);
Distance distance_to(const Box& box, const Vec3& p);

}  // namespace slipstitch
