// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace slipstitch::testing {

/// Every effect that a scene can ask for, with parameters that make each of them matter at the scale of a stitch.
Effects all_effects();

/// Two yarns of millimetre size, clasped twice, every segment at rest near its drawn length. Yarn A visits nodes
/// 0 1 2 3 4 5, yarn B 6 1 2 4 3 7; contact 0 is (1, 2), contact 1 is (3, 4), where B runs against the labels.
/// With colliders a dynamic sphere lies on node 6; its centre is node 8.
Model clasped_yarns(const Effects& effects);

/// The clasped yarns with a dead load.
Model loaded(const Effects& effects);
/// With every effect and the load, and with none of either.
Model everything_on();
Model everything_off();

/// A state at rest in time: q, random velocities and momenta, anchors at q.
State state_at(const Model& model, const VecX& q, std::mt19937_64& random);

/// Full coordinates with what a difference quotient there may use.
struct Pose {
  VecX q;
  double step = 1e-6;  // [m], small against the distance to the nearest singularity
  int order = 2;       // 1: on a singularity of the third derivative
};

/// Random poses around the drawn one and poses near every degenerate configuration the terms know: straight and folded
/// bends, compressed and crowded segments, yarn running nearly straight through a contact, wraps folded to +-pi.
std::vector<Pose> sample_poses(const Model& model);

}  // namespace slipstitch::testing
