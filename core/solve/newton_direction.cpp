// SPDX-License-Identifier: MIT
#include "solve/newton_direction.h"

#include <algorithm>
#include <cmath>

#include "solve/conjugate_gradients.h"

namespace slipstitch {
namespace {

constexpr double kCgTolerance = 1e-3;  // looser leaves the soft directions, which hold little energy, unsolved
constexpr int kMaxCgIterations = 30;
constexpr double kNearbyTolerance = 1e-6;
constexpr int kCgWorthAFactor = 6;  // iterations that take as long as a factorisation, 40 x 40 loops
constexpr double kFarAbove = 1e4;   // gradient tolerances, from where on most_shift is all there
constexpr double kFirstShift = 1e-8, kShiftGrowth = 100.0, kLargestShift = 10.0;  // of the mean diagonal

std::size_t diagonal_slot(const SparseMatrix& h, int c) {
  return static_cast<std::size_t>(h.pattern->column_first[static_cast<std::size_t>(c)]);
}

double mean_diagonal(const SparseMatrix& h) {
  double sum = 0.0;
  for (int c = 0; c < h.pattern->n; ++c) sum += std::abs(h.values[diagonal_slot(h, c)]);
  return sum / std::max(1, h.pattern->n);
}

void shift_by(SparseMatrix& h, double shift) {
  for (int c = 0; c < h.pattern->n; ++c) h.values[diagonal_slot(h, c)] += shift;
}

void shift_all(SparseMatrix& h, double share_of_mean) { shift_by(h, share_of_mean * mean_diagonal(h)); }

/// Where most_shift says so, less the nearer the end is: a shift that stays makes steps along what it outweighs shrink
/// slowly, one that goes with the gradient leaves them quadratic, also where the Hessian is singular. [Li, Fukushima,
/// Qi and Yamashita, "Regularized Newton methods for convex minimization problems with singular solutions", Comput.
/// Optim. Appl. 28, 2004]
void shift_as_asked(SparseMatrix& h, const VecX& gradient, const NewtonOptions& options) {
  if (!(options.relative_shift > 0.0)) return;
  const double share = options.relative_shift * mean_diagonal(h);
  if (options.most_shift.size() == 0) return shift_by(h, share);
  const double left = gradient.cwiseAbs().maxCoeff() / (kFarAbove * options.gradient_tolerance);
  for (int c = 0; c < h.pattern->n; ++c)
    h.values[diagonal_slot(h, c)] += std::min(1.0, left) * std::min(share, options.most_shift[c]);
}

LinearStatus factor(LinearSolver& solver, const SparseMatrix& h, NewtonReport& report) {
  ++report.factorizations;
  return solver.factor(h);
}

/// Semidefinite is enough for the convex part: a shift makes it definite.
LinearStatus factor_convex(Objective& objective, LinearSolver& solver, const VecX& x, const NewtonOptions& options,
                           NewtonReport& report) {
  VecX gradient;
  SparseMatrix h;
  objective.derivatives(x, HessianMode::convex, gradient, h);
  ++report.convex_hessians;
  shift_as_asked(h, gradient, options);
  LinearStatus status = factor(solver, h, report);
  for (double s = kFirstShift; status == LinearStatus::not_positive_definite && s <= kLargestShift; s *= kShiftGrowth) {
    shift_all(h, s);
    status = factor(solver, h, report);
  }
  return status;
}

}  // namespace

void evaluate(Objective& objective, const VecX& x, const NewtonOptions& options, NewtonPoint& point) {
  point.value = objective.derivatives(x, point.mode, point.gradient, point.hessian);
  shift_as_asked(point.hessian, point.gradient, options);
}

bool find_direction_nearby(LinearSolver& solver, NewtonPoint& point, NewtonReport& report) {
  if (!point.has_factor) return false;
  const CgReport cg =
      conjugate_gradients(point.hessian, solver, -point.gradient, kNearbyTolerance, kCgWorthAFactor, point.step);
  report.cg_iterations += cg.iterations;
  point.is_newton_step = cg.converged;
  return cg.converged;
}

LinearStatus find_direction(Objective& objective, LinearSolver& solver, const VecX& x, const NewtonOptions& options,
                            NewtonPoint& point, NewtonReport& report) {
  LinearStatus status = factor(solver, point.hessian, report);
  point.has_factor = true;
  if (status == LinearStatus::not_positive_definite && point.mode == HessianMode::predicted) {
    point.mode = HessianMode::exact;
    evaluate(objective, x, options, point);
    status = factor(solver, point.hessian, report);
  }
  if (status == LinearStatus::ok) {
    status = solver.solve(point.gradient, point.step);
    point.step = -point.step;
    point.is_newton_step = true;
    return status;
  }
  point.has_factor = false;
  if (status != LinearStatus::not_positive_definite || !options.convex_fallback) return status;
  status = factor_convex(objective, solver, x, options, report);
  if (status != LinearStatus::ok) return status;
  const CgReport cg =
      conjugate_gradients(point.hessian, solver, -point.gradient, kCgTolerance, kMaxCgIterations, point.step);
  report.cg_iterations += cg.iterations;
  point.is_newton_step = cg.converged;
  return point.step.allFinite() ? LinearStatus::ok : LinearStatus::no_convergence;
}

}  // namespace slipstitch
