// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"
#include "model/effects.h"

namespace slipstitch {

/// Yarn that keeps a set: every bend has a set angle p >= 0 that its bend angle theta is compared with,
///   V = k_b (theta^2 - 2 p m(theta) + p^2)/W,   m = theta^2/sqrt(theta^2 + kSetSmoothing^2),
/// which is k_b (theta - p)^2/W but for a smoothed cone at theta = 0, and bending_energy at p = 0. The set has no
/// direction: a bend that is opened to straight may close again in any plane.
inline constexpr double kSetSmoothing = 0.05;  // [rad]
double set_bending_energy(double k_b, double p, const Vec<11>& q, Vec<11>* g, Mat<11>* hess);
void convex_set_bending(double k_b, double p, const Vec<11>& q, Mat<11>& hess);

/// The set p after h seconds at bend angle theta: dp/dt = (|m - p| - yield)_+ sign(m - p)/relaxation time, exactly.
double crept_set(const PlasticityEffect& effect, double theta, double p, double h);

}  // namespace slipstitch
