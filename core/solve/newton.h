// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

#include "solve/linear_solver.h"

namespace slipstitch {

enum class HessianMode {
  exact,
  convexified  // without known negative parts, where that is cheap; still not definite in general
};

/// A smooth function of n unknowns with a sparse Hessian.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual double value(const VecX& x) = 0;
  /// Returns the value; fills g (n) and the values of h on its pattern.
  virtual double derivatives(const VecX& x, HessianMode mode, VecX& g, SparseMatrix& h) = 0;
  /// Largest a in (0, 1] such that x + a dx keeps what must never be broken.
  virtual double max_step(const VecX& x, const VecX& dx) = 0;
  /// Magnitude of the terms summed in value(): its round-off is about 1e-16 times this.
  virtual double value_scale() const = 0;
};

struct NewtonOptions {
  double step_tolerance = 0.0;      // stop when max |Newton step| <= this [unit of x]; 0: not used
  double gradient_tolerance = 0.0;  // stop when max |gradient| <= this [unit of value/x]; 0: not used
  double relative_shift = 0.0;      // added to the diagonal, in units of its mean; > 0 where rigid motion is free
  int max_iterations = 60;
  std::function<bool()> should_stop;  // polled every iteration; may be empty
};

enum class NewtonStatus { converged, too_many_iterations, stalled, not_finite, linear_failure, cancelled };

struct NewtonReport {
  NewtonStatus status = NewtonStatus::not_finite;
  int iterations = 0, factorizations = 0, shifted_hessians = 0, backtracks = 0;
  double max_step = 0.0;      // max |Newton step| of the last iteration
  double max_gradient = 0.0;  // max |gradient| where it was last evaluated
};

std::string_view to_string(NewtonStatus status);

/// Minimises from x (changed in place) by Newton's method with an Armijo line search [Nocedal and Wright 2006, 3.1].
/// Where the Hessian is not positive definite a multiple of the identity is added until it is [ibid., 3.4].
NewtonReport newton(Objective& objective, LinearSolver& solver, const NewtonOptions& options, VecX& x);

}  // namespace slipstitch
