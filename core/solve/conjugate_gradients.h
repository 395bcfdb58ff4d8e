// SPDX-License-Identifier: MIT
#pragma once

#include "solve/linear_solver.h"

namespace slipstitch {

struct CgReport {
  int iterations = 0;
  bool converged = false;
  bool negative_curvature = false;
};

/// Conjugate gradients for A x = b from x = 0, preconditioned by P, the last factorisation of `preconditioner`. Ends when
/// r^T P^-1 r <= tolerance^2 b^T P^-1 b, or at the first direction p with p^T A p <= 0: then x is the iterate so far, or
/// P^-1 b if that is the first direction, and b^T x > 0 either way. [Nocedal and Wright 2006, algorithm 7.1]
CgReport conjugate_gradients(const SparseMatrix& a, LinearSolver& preconditioner, const VecX& b, double tolerance,
                             int max_iterations, VecX& x);

}  // namespace slipstitch
