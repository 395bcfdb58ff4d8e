// SPDX-License-Identifier: MIT
#include "solve/newton.h"

#include <cmath>

namespace slipstitch {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMaxBacktracks = 40;
constexpr int kMaxFlatIterations = 12;  // iterations without visible decrease before the search counts as stalled
constexpr int kRetryExactAfter = 3;     // projected iterations before the exact Hessian is tried again
constexpr double kFirstShift = 1e-10;   // of the mean diagonal; grows by kShiftGrowth until the matrix is definite
constexpr double kShiftGrowth = 100.0;
constexpr double kLargestShift = 1.0;

struct Workspace {
  VecX gradient, step, trial;
  SparseMatrix hessian;
  double value = 0.0;
  int projected_left = 0;
};

double mean_diagonal(const SparseMatrix& h) {
  double sum = 0.0;
  for (int c = 0; c < h.pattern->n; ++c)
    sum += std::abs(h.values[static_cast<std::size_t>(h.pattern->column_first[static_cast<std::size_t>(c)])]);
  return sum / std::max(1, h.pattern->n);
}

void add_to_diagonal(SparseMatrix& h, double shift) {
  for (int c = 0; c < h.pattern->n; ++c)
    h.values[static_cast<std::size_t>(h.pattern->column_first[static_cast<std::size_t>(c)])] += shift;
}

LinearStatus factor_shifted(LinearSolver& solver, SparseMatrix& h, NewtonReport& report) {
  const double mean = mean_diagonal(h);
  double added = 0.0;
  for (double shift = kFirstShift; shift <= kLargestShift; shift *= kShiftGrowth) {
    add_to_diagonal(h, shift * mean - added);
    added = shift * mean;
    ++report.factorizations;
    const LinearStatus status = solver.factor(h);
    if (status != LinearStatus::not_positive_definite) return status;
  }
  return LinearStatus::not_positive_definite;
}

void evaluate(Objective& objective, const VecX& x, Workspace& w, const NewtonOptions& options) {
  const HessianMode mode = w.projected_left > 0 ? HessianMode::projected : HessianMode::exact;
  w.value = objective.derivatives(x, mode, w.gradient, w.hessian);
  if (options.relative_shift > 0.0) add_to_diagonal(w.hessian, options.relative_shift * mean_diagonal(w.hessian));
}

/// Newton direction from the evaluated derivatives; falls back to the projected, then to a shifted Hessian.
LinearStatus direction(Objective& objective, LinearSolver& solver, const VecX& x, Workspace& w, NewtonReport& report) {
  ++report.factorizations;
  LinearStatus status = solver.factor(w.hessian);
  if (status == LinearStatus::not_positive_definite) {
    w.projected_left = kRetryExactAfter;
    w.value = objective.derivatives(x, HessianMode::projected, w.gradient, w.hessian);
    status = factor_shifted(solver, w.hessian, report);
  }
  if (w.projected_left > 0) {
    --w.projected_left;
    ++report.projected_hessians;
  }
  if (status != LinearStatus::ok) return status;
  status = solver.solve(w.gradient, w.step);
  w.step = -w.step;
  return status;
}

enum class Search { decreased, flat, failed };

/// Moves x along w.step. Flat: the decrease is below the value's round-off, the step is taken on trust.
Search line_search(Objective& objective, VecX& x, Workspace& w, NewtonReport& report) {
  const double slope = w.gradient.dot(w.step);
  if (!(slope < 0.0)) return slope == 0.0 ? Search::flat : Search::failed;
  const double noise = 1e-14 * objective.value_scale();
  double a = objective.max_step(x, w.step);
  for (int k = 0; k < kMaxBacktracks; ++k, a *= 0.5) {
    w.trial = x + a * w.step;
    const double value = objective.value(w.trial);
    const bool flat = std::abs(a * slope) <= noise;
    if (std::isfinite(value) && value <= w.value + kArmijo * a * slope + (flat ? noise : 0.0)) {
      x = w.trial;
      return flat ? Search::flat : Search::decreased;
    }
    ++report.backtracks;
  }
  return Search::failed;
}

}  // namespace

std::string_view to_string(NewtonStatus status) {
  switch (status) {
    case NewtonStatus::converged: return "converged";
    case NewtonStatus::too_many_iterations: return "too many Newton iterations";
    case NewtonStatus::stalled: return "line search stalled";
    case NewtonStatus::not_finite: return "value not finite";
    case NewtonStatus::linear_failure: return "linear solve failed";
    case NewtonStatus::cancelled: return "cancelled";
  }
  return "unknown";
}

NewtonReport newton(Objective& objective, LinearSolver& solver, const NewtonOptions& options, VecX& x) {
  NewtonReport report;
  Workspace w;
  int flat = 0;
  const auto done = [&](NewtonStatus status) {
    report.status = status;
    return report;
  };
  for (; report.iterations < options.max_iterations; ++report.iterations) {
    if (options.should_stop && options.should_stop()) return done(NewtonStatus::cancelled);
    evaluate(objective, x, w, options);
    if (!std::isfinite(w.value) || !w.gradient.allFinite()) return done(NewtonStatus::not_finite);
    report.max_gradient = w.gradient.size() ? w.gradient.cwiseAbs().maxCoeff() : 0.0;
    if (report.max_gradient <= options.gradient_tolerance) return done(NewtonStatus::converged);
    if (direction(objective, solver, x, w, report) != LinearStatus::ok) return done(NewtonStatus::linear_failure);
    report.max_step = w.step.cwiseAbs().maxCoeff();
    const Search search = line_search(objective, x, w, report);
    if (report.max_step <= options.step_tolerance && search != Search::failed) {
      ++report.iterations;
      return done(NewtonStatus::converged);
    }
    if (search == Search::failed) {
      if (w.projected_left > 0) return done(NewtonStatus::stalled);
      w.projected_left = kRetryExactAfter;  // the exact Hessian gave a bad direction; try the projected one
      continue;
    }
    flat = search == Search::flat ? flat + 1 : 0;
    if (flat > kMaxFlatIterations) return done(NewtonStatus::stalled);
  }
  return done(NewtonStatus::too_many_iterations);
}

}  // namespace slipstitch
