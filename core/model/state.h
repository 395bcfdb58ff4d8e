// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// Everything that changes in time; a copy is a snapshot. Sizes in full coordinates (topology.h).
struct State {
  double t = 0.0;  // [s]
  VecX q;          // positions and arc lengths [m] (num_coords)
  VecX v;          // dq/dt of the last step [m/s] (num_coords)
  VecX p;          // generalised momentum M v [kg m/s] (num_coords)
  VecX anchor;     // friction anchors, arc length [m] (num_visits); follows q where friction is off
  VecX set_angle;  // rest angle of the bend at every visit [rad] (num_visits); empty without plasticity
};

}  // namespace slipstitch
