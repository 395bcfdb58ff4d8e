// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "math/types.h"
#include "model/scene.h"

namespace slipstitch {

/// Moves unplaced positions (x course, y wale, z right side; lower left corner at 0) to where the scene wants them.
void place_flat(const Placement& placement, std::vector<Vec3>& positions);

/// The same as a tube of the given circumference around the wale axis, right side outwards; x = 0 lies at the origin.
void place_tube(const Placement& placement, double circumference_m, std::vector<Vec3>& positions);

/// Adds uniform noise in [-amplitude, amplitude] to every coordinate in order; the same numbers on every platform.
void add_noise(double amplitude_m, std::uint64_t seed, std::vector<Vec3>& positions);

}  // namespace slipstitch
