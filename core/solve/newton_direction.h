// SPDX-License-Identifier: MIT
#pragma once

#include "solve/newton.h"

namespace slipstitch {

/// Value, derivatives and search direction at one iterate.
struct NewtonPoint {
  double value = 0.0;
  VecX gradient, step;
  SparseMatrix hessian;
  HessianMode mode = HessianMode::predicted;
  bool is_newton_step = false;  // false: cut short at negative curvature or before it was solved
  bool has_factor = false;      // the solver holds the factor of this Hessian or of one near it
};

/// value, gradient and hessian at x in the point's mode.
void evaluate(Objective& objective, const VecX& x, const NewtonOptions& options, NewtonPoint& point);

/// point.step from point.gradient and point.hessian at x. May turn point.mode from predicted to exact.
LinearStatus find_direction(Objective& objective, LinearSolver& solver, const VecX& x, const NewtonOptions& options,
                            NewtonPoint& point, NewtonReport& report);

/// The same by conjugate gradients with the factor at hand, if there is one and a few iterations do.
bool find_direction_nearby(LinearSolver& solver, NewtonPoint& point, NewtonReport& report);

}  // namespace slipstitch
