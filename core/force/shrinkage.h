// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/effects.h"

namespace slipstitch {

/// Rest length of all yarn at time t over its arc length: 1 at t = 0 unless a keyframe says otherwise, linear in
/// between, held after the last. An arc length D stands for factor D of yarn wherever stretch is measured; mass,
/// bending, wrapping, damping and the distances kept along the yarn go on counting D.
double length_factor(const std::vector<LengthKeyframe>& keyframes, double t);
inline double length_factor(const Effects& effects, double t) {
  return effects.shrinkage ? length_factor(effects.shrinkage->keyframes, t) : 1.0;
}

/// A segment x0, u0, x1, u1 with its arc lengths times `factor`, and the chain rule back from there.
Vec<8> scaled_arcs(const Vec<8>& q, double factor);
void scale_arc_rows(double factor, Vec<8>& g);
void scale_arc_rows(double factor, Mat<8>& hess);  // and columns

}  // namespace slipstitch
