// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

#include "solve/linear_solver.h"
#include "solve/objective.h"

namespace slipstitch {

struct NewtonOptions {
  double step_tolerance = 0.0;      // stop when the Newton step's size is <= this [unit of x]; 0: not used
  // Also stop where full steps shrink so fast that all that are left are together no longer than step_tolerance.
  // [Hairer and Wanner 1996, IV.8]
  bool foresee = false;
  // Stop when max |gradient| <= this [unit of value/x], or no more than what the last digits of x make of it; 0: not used.
  double gradient_tolerance = 0.0;
  double relative_shift = 0.0;      // added to the diagonal, in units of its mean; > 0 where rigid motion is free
  VecX most_shift = {};             // but never more than this [value/x^2] (n); empty: no limit
  int max_iterations = 60;
  bool convex_fallback = true;        // false: an indefinite Hessian ends the search
  std::function<bool()> should_stop;  // polled every iteration; may be empty
};

enum class NewtonStatus { converged, too_many_iterations, stalled, not_finite, linear_failure, cancelled };

struct NewtonReport {
  NewtonStatus status = NewtonStatus::not_finite;
  int iterations = 0, factorizations = 0, convex_hessians = 0, cg_iterations = 0, backtracks = 0;
  double max_step = 0.0;      // size of the last iteration's Newton step (Objective::step_size)
  double max_gradient = 0.0;  // max |gradient| where it was last evaluated
  int worst = -1;             // unknown that the last step would move most; -1: none converged to a step
};

std::string_view to_string(NewtonStatus status);

/// Counts of an earlier solve, into the report of one that they belong to.
void add_counts(const NewtonReport& first, NewtonReport& report);

/// Minimises from x (changed in place) by Newton's method with an Armijo line search [Nocedal and Wright 2006, 3.1].
/// The first Hessian that Cholesky accepts gives the direction: with the stresses predicted by the step before, which
/// saves yarn that turns from locking in the tension of its own overshoot [Magisano, Leonetti and Garcea 2017], then the
/// exact one. Where that is indefinite, its convex part preconditions conjugate gradients on it, which stop at negative
/// curvature [Nocedal and Wright 2006, 7.1].
NewtonReport newton(Objective& objective, LinearSolver& solver, const NewtonOptions& options, VecX& x);

}  // namespace slipstitch
