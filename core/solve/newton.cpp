// SPDX-License-Identifier: MIT
#include "solve/newton.h"

#include <cmath>

namespace slipstitch {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMaxBacktracks = 40;
constexpr int kWatchedSteps = 4;
constexpr int kMaxFlatIterations = 12;  // iterations without visible decrease before the search counts as stalled
constexpr int kRetryExactAfter = 3;
constexpr double kFirstShift = 1e-8;    // of the mean diagonal
constexpr double kShiftGrowth = 8.0;    // after a failed factorisation
constexpr double kShiftDecay = 4.0;     // after a definite one
constexpr double kLargestShift = 10.0;
struct Workspace {
  VecX gradient, step;
  SparseMatrix hessian;
  double value = 0.0;
  double shift_used = 0.0;   // in the present direction
  double shift = 0.0;        // on the diagonal, in units of its mean
  int convexified_left = 0;  // iterations before the exact Hessian is tried again
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

/// Factors the Hessian plus the smallest tried shift that makes it definite. An indefinite Hessian is the normal case
/// here (flat stockinette is unstable against curling), but its negative curvatures are small and few: a shift of
/// that size keeps all other directions exact, where clamping every element would stiffen them all.
LinearStatus factor_definite(LinearSolver& solver, Workspace& w, double least_shift, NewtonReport& report) {
  const double mean = mean_diagonal(w.hessian);
  double added = 0.0;
  w.shift = std::max(w.shift / kShiftDecay, least_shift);
  if (w.shift < kFirstShift) w.shift = least_shift;
  for (;;) {
    add_to_diagonal(w.hessian, w.shift * mean - added);
    added = w.shift * mean;
    ++report.factorizations;
    const LinearStatus status = solver.factor(w.hessian);
    if (status != LinearStatus::not_positive_definite || w.shift >= kLargestShift) {
      w.shift_used = w.shift;
      if (w.shift > least_shift) ++report.shifted_hessians;
      return status;
    }
    w.shift = std::max(kFirstShift, kShiftGrowth * w.shift);
  }
}

void evaluate(Objective& objective, const VecX& x, HessianMode mode, Workspace& w) {
  w.value = objective.derivatives(x, mode, w.gradient, w.hessian);
}

/// The exact Hessian if it is definite, else the convexified one, shifted as far as it takes.
LinearStatus direction(Objective& objective, LinearSolver& solver, const VecX& x, double least_shift, Workspace& w,
                       NewtonReport& report) {
  LinearStatus status = LinearStatus::not_positive_definite;
  if (w.convexified_left == 0) {
    if (least_shift > 0.0) add_to_diagonal(w.hessian, least_shift * mean_diagonal(w.hessian));
    ++report.factorizations;
    status = solver.factor(w.hessian);
    w.shift_used = 0.0;
    if (status == LinearStatus::not_positive_definite) {
      w.convexified_left = kRetryExactAfter;
      evaluate(objective, x, HessianMode::convexified, w);
    }
  } else {
    --w.convexified_left;
  }
  if (status == LinearStatus::not_positive_definite) status = factor_definite(solver, w, least_shift, report);
  if (status != LinearStatus::ok) return status;
  status = solver.solve(w.gradient, w.step);
  w.step = -w.step;
  return status;
}

enum class Search { decreased, flat, failed };

/// Armijo backtracking from x along `step` with first trial a. Flat: the decrease is below the value's round-off, the
/// step is taken on trust.
Search line_search(Objective& objective, VecX& x, const VecX& step, double value0, double slope, double a,
                   NewtonReport& report) {
  const double noise = 1e-14 * objective.value_scale();
  VecX trial;
  for (int k = 0; k < kMaxBacktracks; ++k, a *= 0.5) {
    trial = x + a * step;
    const double value = objective.value(trial);
    const bool flat = std::abs(a * slope) <= noise;
    if (std::isfinite(value) && value <= value0 + kArmijo * a * slope + (flat ? noise : 0.0)) {
      x = trial;
      return flat ? Search::flat : Search::decreased;
    }
    ++report.backtracks;
  }
  return Search::failed;
}

/// Lets the value rise for a few full steps before insisting on descent [Chamberlain et al. 1982; Nocedal and Wright
/// 2006, 15.6]. Yarn is a thousand times stiffer in stretch than in bending: a step that turns a segment by phi
/// stretches it by phi^2/2, which plain Armijo answers with small turns but the next full step simply removes.
class Watchdog {
 public:
  /// Moves x by the direction in w. Returns what the search at the reference point gave.
  Search advance(Objective& objective, VecX& x, const Workspace& w, NewtonReport& report) {
    const double slope = w.gradient.dot(w.step);
    turned_back_ = false;
    if (left_ > 0 && w.value <= value_ + kArmijo * a_ * slope_) left_ = 0;
    if (left_ > 0) {
      const double a = objective.max_step(x, w.step);
      const VecX trial = x + a * w.step;
      if (--left_ > 0 && std::isfinite(objective.value(trial))) {
        x = trial;
        return Search::decreased;
      }
      return turn_back(objective, x, report);
    }
    if (!(slope < 0.0)) return slope == 0.0 ? Search::flat : Search::failed;
    const double a = objective.max_step(x, w.step);
    const VecX trial = x + a * w.step;
    const double value = objective.value(trial);
    if (!std::isfinite(value) || value <= w.value + kArmijo * a * slope ||
        std::abs(a * slope) <= 1e-14 * objective.value_scale())
      return line_search(objective, x, w.step, w.value, slope, a, report);
    x_ = x;
    step_ = w.step;
    value_ = w.value;
    slope_ = slope;
    a_ = a;
    left_ = kWatchedSteps;
    x = trial;
    return Search::decreased;
  }
  /// Gives up the trial and searches from the reference point along its direction. Only while watching.
  Search turn_back(Objective& objective, VecX& x, NewtonReport& report) {
    left_ = 0;
    turned_back_ = true;
    x = x_;
    return line_search(objective, x, step_, value_, slope_, 0.5 * a_, report);
  }
  bool watching() const { return left_ > 0; }
  /// Whether x is where the direction in w led: neither on trial nor back at the reference point.
  bool settled() const { return left_ == 0 && !turned_back_; }

 private:
  VecX x_, step_;  // where the value last was lowest, and the direction there
  double value_ = 0.0, slope_ = 0.0, a_ = 1.0;
  int left_ = 0;
  bool turned_back_ = false;
};

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
  Watchdog watchdog;
  int flat = 0;
  const auto done = [&](NewtonStatus status) {
    report.status = status;
    return report;
  };
  for (; report.iterations < options.max_iterations; ++report.iterations) {
    if (options.should_stop && options.should_stop()) return done(NewtonStatus::cancelled);
    evaluate(objective, x, w.convexified_left > 0 ? HessianMode::convexified : HessianMode::exact, w);
    if (!std::isfinite(w.value) || !w.gradient.allFinite()) return done(NewtonStatus::not_finite);
    report.max_gradient = w.gradient.size() ? w.gradient.cwiseAbs().maxCoeff() : 0.0;
    if (report.max_gradient <= options.gradient_tolerance) return done(NewtonStatus::converged);
    if (direction(objective, solver, x, options.relative_shift, w, report) != LinearStatus::ok) {
      if (!watchdog.watching()) return done(NewtonStatus::linear_failure);
      if (watchdog.turn_back(objective, x, report) == Search::failed) return done(NewtonStatus::stalled);
      continue;
    }
    report.max_step = w.step.cwiseAbs().maxCoeff();
    const Search search = watchdog.advance(objective, x, w, report);
    // A small step ends the search even if round-off hides its decrease, as where every energy is zero; but not a step
    // that a shift made small: soft directions, such as arc lengths that only their own mass holds, may be far off.
    if (report.max_step <= options.step_tolerance && watchdog.settled()) {
      if (w.shift_used <= options.relative_shift) {
        ++report.iterations;
        return done(NewtonStatus::converged);
      }
      w.convexified_left = 0;  // try the exact Hessian next
    }
    if (search == Search::failed) return done(NewtonStatus::stalled);
    flat = search == Search::flat ? flat + 1 : 0;
    if (flat > kMaxFlatIterations) return done(NewtonStatus::stalled);
  }
  return done(NewtonStatus::too_many_iterations);
}

}  // namespace slipstitch
