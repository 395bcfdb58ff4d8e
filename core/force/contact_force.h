// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace slipstitch {

/// Normal force between the yarns at every visit [N], >= 0, 0 where nothing is touched (num_visits). Nodes carry no
/// normal separation, so compression is estimated from the forces each yarn alone puts on the shared node, F = stretch
/// + bending + that yarn's side of the wraps [Cirio et al. 2017, compression estimate]:
///   stitch contact  F_n = max(0, 1/2 n.(F_u - F_v)) at q0 and at q1, with one n per contact: the part normal to the
///                   axis of (t(q0,q4) + t(q1,q5)) - (t(q0,q2) + t(q1,q3)), t unit tangents; it points to u's side;
///   crossing        F_n = |1/2 n.(F_u - F_v)|, n normal to both yarns (which lies on top is not stored);
///   guide           F_n = max(0, n.F_u), n the bisector of the yarn's two directions.
std::vector<double> estimate_normal_forces(const Model& model, const State& state);

}  // namespace slipstitch
