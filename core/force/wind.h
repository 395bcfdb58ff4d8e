// SPDX-License-Identifier: MIT
#pragma once

#include "model/effects.h"

namespace slipstitch {

/// Velocity of the air at time t [m/s]: velocity + gust sin(2 pi t/period); 0 without wind.
Vec3 air_velocity(const Effects& effects, double t);

}  // namespace slipstitch
