// SPDX-License-Identifier: MIT
#pragma once

#include "sim/simulation.h"

namespace slipstitch {

/// Longest step <= h [s] from here in which scripts move no body that is near yarn, and no yarn that can touch, by more
/// than 0.8 radii; thin bodies by less. A step ends with scripted things where their script has them, and yarn that they
/// went over is moved out of them by the shortest way: beyond a radius that may lead out of the far side.
double longest_step(const Simulation& sim, double h);

}  // namespace slipstitch
