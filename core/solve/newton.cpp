// SPDX-License-Identifier: MIT
#include "solve/newton.h"

#include <cmath>
#include <limits>

#include "solve/line_search.h"
#include "solve/newton_direction.h"

namespace slipstitch {
namespace {

constexpr double kNearby = 30.0;   // steps up to this many tolerances leave the last factor a good preconditioner
constexpr double kFarBelow = 1e-6;  // of the tolerance: no search can tell such a step from round-off, none need take it
constexpr double kRoundOff = 2.0;   // of what one digit of every unknown makes of the gradient
constexpr double kFalling = 0.9;    // of the gradient or step, that is a decrease which the value may hide
constexpr int kMaxFlatIterations = 12;  // iterations without visible decrease before the search counts as stalled

/// Whether what is left of the gradient is no more than the last digits of x make of it. The last digit of an arc
/// length of a metre, held by sliding damping in a short step, is a force of 1e-8 N.
bool is_round_off(const NewtonPoint& point, const VecX& x, double tolerance) {
  VecX known;
  multiply_magnitudes(point.hessian, x, known);
  known *= kRoundOff * std::numeric_limits<double>::epsilon();
  return (point.gradient.array().abs() <= known.array().max(tolerance)).all();
}

/// Whether all steps after one of size `step`, the full one before of size `before`, are together within `tolerance`,
/// if they go on to shrink at least as fast.
bool ends_within(double tolerance, double step, double before) {
  constexpr double kFast = 0.3;
  return step < kFast * before && step * step <= tolerance * (before - step);
}

}  // namespace

std::string_view to_string(NewtonStatus status) {
  switch (status) {
    case NewtonStatus::converged:
      return "converged";
    case NewtonStatus::too_many_iterations:
      return "too many Newton iterations";
    case NewtonStatus::stalled:
      return "line search stalled";
    case NewtonStatus::not_finite:
      return "value not finite";
    case NewtonStatus::linear_failure:
      return "linear solve failed";
    case NewtonStatus::cancelled:
      return "cancelled";
  }
  return "unknown";
}

void add_counts(const NewtonReport& first, NewtonReport& report) {
  report.iterations += first.iterations;
  report.factorizations += first.factorizations;
  report.convex_hessians += first.convex_hessians;
  report.cg_iterations += first.cg_iterations;
  report.backtracks += first.backtracks;
}

NewtonReport newton(Objective& objective, LinearSolver& solver, const NewtonOptions& options, VecX& x) {
  NewtonReport report;
  NewtonPoint point;
  Watchdog watchdog;
  int flat = 0;
  double least = std::numeric_limits<double>::infinity();  // gradient or step since the value fell last
  double last_full_step = 0.0;
  const auto done = [&](NewtonStatus status) {
    report.status = status;
    if (point.step.size() > 0 && point.step.allFinite()) point.step.cwiseAbs().maxCoeff(&report.worst);
    return report;
  };
  objective.settle(x, x);
  for (; report.iterations < options.max_iterations; ++report.iterations) {
    if (options.should_stop && options.should_stop()) return done(NewtonStatus::cancelled);
    evaluate(objective, x, options, point);
    if (!std::isfinite(point.value) || !point.gradient.allFinite()) return done(NewtonStatus::not_finite);
    report.max_gradient = point.gradient.size() > 0 ? point.gradient.cwiseAbs().maxCoeff() : 0.0;
    if (report.max_gradient <= options.gradient_tolerance) return done(NewtonStatus::converged);
    if (options.gradient_tolerance > 0.0 && is_round_off(point, x, options.gradient_tolerance))
      return done(NewtonStatus::converged);
    const bool nearby = report.iterations > 0 && report.max_step <= kNearby * options.step_tolerance;
    if (!(nearby && find_direction_nearby(solver, point, report)) &&
        find_direction(objective, solver, x, options, point, report) != LinearStatus::ok) {
      if (!watchdog.watching()) return done(NewtonStatus::linear_failure);
      if (watchdog.turn_back(objective, x, report) == Search::failed) return done(NewtonStatus::stalled);
      continue;
    }
    report.max_step = objective.step_size(point.step);
    if (report.max_step <= kFarBelow * options.step_tolerance && !watchdog.watching() && point.is_newton_step) {
      return done(NewtonStatus::converged);
    }
    const Search search = watchdog.advance(objective, x, point, report);
    report.max_step = objective.step_size(point.step);
    // A small step ends the search even if round-off hides its decrease, as where every energy is zero; but not one
    // that was cut short: soft directions, such as arc lengths that only their own mass holds, may still be far off.
    if (report.max_step <= options.step_tolerance && watchdog.settled() && point.is_newton_step) {
      ++report.iterations;
      return done(NewtonStatus::converged);
    }
    const bool full = point.is_newton_step && watchdog.settled() && watchdog.share() == 1.0;
    if (options.foresee && full && ends_within(options.step_tolerance, report.max_step, last_full_step)) {
      ++report.iterations;
      return done(NewtonStatus::converged);
    }
    last_full_step = full ? report.max_step : 0.0;
    if (search == Search::failed) return done(NewtonStatus::stalled);
    const double left = options.gradient_tolerance > 0.0 ? report.max_gradient : report.max_step;
    const bool falls = left <= kFalling * least;
    if (falls) least = left;
    flat = search == Search::flat && !falls ? flat + 1 : 0;
    if (search != Search::flat) least = std::numeric_limits<double>::infinity();
    if (flat > kMaxFlatIterations) return done(NewtonStatus::stalled);
  }
  return done(NewtonStatus::too_many_iterations);
}

}  // namespace slipstitch
