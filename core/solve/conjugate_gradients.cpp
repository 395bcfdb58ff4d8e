// SPDX-License-Identifier: MIT
#include "solve/conjugate_gradients.h"

namespace slipstitch {

CgReport conjugate_gradients(const SparseMatrix& a, LinearSolver& preconditioner, const VecX& b, double tolerance,
                             int max_iterations, VecX& x) {
  CgReport report;
  VecX r = b, z, ap;
  x.setZero(b.size());
  if (preconditioner.solve(r, z) != LinearStatus::ok) return report;
  VecX p = z;
  double rz = r.dot(z);
  const double goal = tolerance * tolerance * rz;
  report.converged = rz == 0.0;
  while (!report.converged && report.iterations < max_iterations) {
    multiply(a, p, ap);
    const double curvature = p.dot(ap);
    if (!(curvature > 0.0)) {
      if (report.iterations == 0) x = p;
      report.negative_curvature = true;
      return report;
    }
    ++report.iterations;
    x += (rz / curvature) * p;
    r -= (rz / curvature) * ap;
    if (preconditioner.solve(r, z) != LinearStatus::ok) return report;
    const double next = r.dot(z);
    if (next <= goal) {
      report.converged = true;
      return report;
    }
    p = z + (next / rz) * p;
    rz = next;
  }
  return report;
}

}  // namespace slipstitch
