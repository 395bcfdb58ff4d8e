// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "math/types.h"

namespace slipstitch {

/// A point of yarn that friction holds on a collider.
struct Touch {
  int sample = 0, body = 0;      // of TouchParts, of its bodies or of Model::bodies
  Vec3 anchor = Vec3::Zero();    // where friction holds it, in the body at t = 0, from the centre if dynamic [m]
  double normal_force = 0.0;     // > 0 [N]
};

/// Everything that changes in time; a copy is a snapshot. Sizes in full coordinates (topology.h).
struct State {
  double t = 0.0;  // [s]
  VecX q;          // positions and arc lengths [m] (num_coords)
  VecX v;          // dq/dt of the last step [m/s] (num_coords)
  VecX p;          // generalised momentum M v [kg m/s] (num_coords)
  VecX anchor;     // friction anchors, arc length [m] (num_visits); empty without friction
  VecX set_angle;  // rest angle of the bend at every visit [rad] (num_visits); empty without plasticity
  std::vector<Touch> touches;            // on colliders that are not dynamic, ascending in sample, then body
  std::vector<Touch> body_touches = {};  // on dynamic ones, likewise
  double h_before = 0.0;                 // the last step, 0: there was none or nothing looks back to it [s]
  VecX q_before = {}, v_before = {}, p_before = {};  // before it; empty without it
};

}  // namespace slipstitch
