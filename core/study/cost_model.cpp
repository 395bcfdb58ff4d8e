// SPDX-License-Identifier: MIT
#include "study/cost_model.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {
namespace {

/// Per second, over the last half of the time that the course covers.
RunPoint late_rate(const RunCourse& course) {
  const RunPoint& last = course.back();
  const RunPoint middle = counts_at(course, 0.5 * last.t);
  const double span = last.t - middle.t;
  return {1.0, (last.steps - middle.steps) / span, (last.iterations - middle.iterations) / span};
}

RunPoint between(const RunPoint& a, const RunPoint& b, double t) {
  const double share = b.t > a.t ? (t - a.t) / (b.t - a.t) : 1.0;
  return {t, a.steps + share * (b.steps - a.steps), a.iterations + share * (b.iterations - a.iterations)};
}

double ratio(double part, double whole) { return part > 0.0 && whole > 0.0 ? part / whole : 1.0; }

/// Counts are at least those so far.
double mixed(double first, double second, double share, double least) {
  return std::max(least, std::pow(first, share) * std::pow(second, 1.0 - share));
}

}  // namespace

double iteration_s(const IterationCost& cost, const ProblemSize& size) {
  return cost.per_nonzero_s * size.nonzeros + cost.per_operation_s * size.factor.operations;
}

IterationCost fit_cost(std::span<const TimedIterations> timed) {
  IterationCost cost;
  double most = 0.0, sum = 0.0;
  int samples = 0;
  for (const TimedIterations& one : timed) {
    if (!(one.iterations > 0.0) || one.size.factor.operations <= most) continue;
    most = one.size.factor.operations;
    cost.per_operation_s = one.factor_s / (one.iterations * most);
  }
  for (const TimedIterations& one : timed) {
    if (!(one.iterations > 0.0)) continue;
    const double rest = one.wall_s / one.iterations - cost.per_operation_s * one.size.factor.operations;
    sum += std::max(0.0, rest) / one.size.nonzeros;
    ++samples;
  }
  if (samples > 0) cost.per_nonzero_s = sum / samples;
  return cost;
}

FactorSize scaled_factor(const ProblemSize& known, int dofs) {
  if (known.dofs < 2 || dofs < 2) return {};
  const double n = dofs, m = known.dofs;
  return {known.factor.entries * n * std::log2(n) / (m * std::log2(m)), known.factor.operations * std::pow(n / m, 1.5)};
}

RunPoint counts_at(const RunCourse& course, double t) {
  if (course.empty()) return {t, 0.0, 0.0};
  RunPoint before{};
  for (const RunPoint& point : course) {
    if (point.t >= t) return between(before, point, t);
    before = point;
  }
  if (!(before.t > 0.0)) return {t, before.steps, before.iterations};
  const RunPoint rate = late_rate(course);
  const double more = t - before.t;
  return {t, before.steps + more * rate.steps, before.iterations + more * rate.iterations};
}

RunPoint extrapolate(const RunCourse& begun, double duration_s, const RunCourse& model) {
  const RunPoint whole = counts_at(model, duration_s);
  if (begun.empty()) return whole;
  const RunPoint& now = begun.back();
  const RunPoint then = counts_at(model, now.t);
  const double trust = now.steps / (now.steps + 1.0);  // the first step alone says little
  const auto end = [&](double count, double model_then, double model_end) {
    return count + std::pow(ratio(count, model_then), trust) * (model_end - model_then);
  };
  return extrapolate(begun, duration_s,
                     RunPoint{duration_s, end(now.steps, then.steps, whole.steps),
                              end(now.iterations, then.iterations, whole.iterations)});
}

RunPoint extrapolate(const RunCourse& begun, double duration_s, const RunPoint& guess) {
  if (begun.empty() || !(begun.back().t > 0.0)) return guess;
  const RunPoint& now = begun.back();
  const double share = now.t / duration_s;
  if (share >= 1.0 - 1e-9) return now;
  const RunPoint alone = counts_at(begun, duration_s);
  return {duration_s, mixed(alone.steps, guess.steps, share, now.steps),
          mixed(alone.iterations, guess.iterations, share, now.iterations)};
}

RunPoint at_tolerance(const RunPoint& known, double known_tolerance_m, double tolerance_m) {
  const double factor = std::sqrt(known_tolerance_m / tolerance_m);
  return {known.t, known.steps * factor, known.iterations * factor};
}

}  // namespace slipstitch
