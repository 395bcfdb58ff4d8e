// SPDX-License-Identifier: MIT
#include "solve/line_search.h"

#include <cmath>
#include <limits>

namespace slipstitch {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMaxBacktracks = 40;
constexpr int kWatchedSteps = 4;
constexpr int kTrusted = 3;     // steps whose decrease is below round-off, in a row, before slopes are asked
constexpr int kHalved = 4;      // trials given up in one solve, likewise
constexpr double kLevel = 0.1;  // of a slope, that is as good as none
constexpr int kMaxCuts = 20;

double noise(const Objective& objective) { return 1e-14 * objective.value_scale(); }

VecX moved(Objective& objective, const VecX& x, double a, const VecX& step) {
  VecX trial = x + a * step;
  objective.settle(trial, x);
  return trial;
}

/// The Armijo condition at x + a step with its value; where the decrease asked for is below the value's round-off, the
/// step is taken on trust.
class Armijo {
 public:
  Armijo(const Objective& objective, double value0, double slope)
      : value0_(value0), slope_(slope), round_off_(noise(objective)) {}
  bool flat(double a) const { return std::abs(a * slope_) <= round_off_; }
  bool holds(double a, double value) const {
    return std::isfinite(value) && value <= value0_ + kArmijo * a * slope_ + (flat(a) ? round_off_ : 0.0);
  }

 private:
  double value0_, slope_, round_off_;
};

/// Halves the step from x, first trial a, until Armijo holds.
Search backtrack(Objective& objective, VecX& x, const VecX& step, const Armijo& armijo, double a, NewtonReport& report) {
  for (int k = 0; k < kMaxBacktracks; ++k, a *= 0.5) {
    VecX trial = moved(objective, x, a, step);
    if (armijo.holds(a, objective.value(trial))) {
      objective.predict(x, VecX::Zero(x.size()));
      x = std::move(trial);
      return armijo.flat(a) ? Search::flat : Search::decreased;
    }
    ++report.backtracks;
  }
  return Search::failed;
}

double slope_at(Objective& objective, HessianMode mode, const VecX& x, const VecX& step) {
  VecX gradient;
  SparseMatrix unused;
  objective.derivatives(x, mode, gradient, unused);
  return gradient.dot(step);
}

/// The share <= a of the step where the slope along it has come to next to nothing, by false position with the Illinois
/// rule; a if it never does. Slopes tell what round-off hides in values: that a step leads as far up beyond a kink as
/// it came down to it. [Hager and Zhang, "A new conjugate gradient method with guaranteed descent and an efficient line
/// search", SIAM J. Optim. 16(1), 2005]
double level_share(Objective& objective, HessianMode mode, const VecX& x, const VecX& step, double slope, double a) {
  double low = 0.0, high = a, at_low = slope, at_high = slope_at(objective, mode, moved(objective, x, a, step), step);
  if (!(at_high > kLevel * -slope)) return a;
  double way = 0.0;
  for (int k = 0; k < kMaxCuts; ++k) {
    const double middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double there = slope_at(objective, mode, moved(objective, x, middle, step), step);
    if (std::abs(there) <= kLevel * -slope) return middle;
    if (there < 0.0) {
      low = middle, at_low = there;
      if (way < 0.0) at_high *= 0.5;
    } else {
      high = middle, at_high = there;
      if (way > 0.0) at_low *= 0.5;
    }
    way = there;
  }
  return low;
}

}  // namespace

Search Watchdog::advance(Objective& objective, VecX& x, const NewtonPoint& point, NewtonReport& report) {
  const double slope = point.gradient.dot(point.step);
  turned_back_ = false;
  share_ = 0.0;
  if (left_ > 0 && point.value <= value_ + kArmijo * a_ * slope_) left_ = 0;
  if (left_ > 0) {
    const double a = objective.max_step(x, point.step);
    VecX trial = moved(objective, x, a, point.step);
    if (--left_ == 0 || !std::isfinite(objective.value(trial))) return turn_back(objective, x, report);
    objective.predict(x, a * point.step);
    x = std::move(trial);
    share_ = a;
    return Search::decreased;
  }
  if (!(slope < 0.0)) return slope == 0.0 ? Search::flat : Search::failed;
  const double a = objective.max_step(x, point.step);
  if (a == 0.0) return Search::failed;
  VecX trial = moved(objective, x, a, point.step);
  if (trial == x) return Search::flat;  // below the round-off of x
  const double value = objective.value(trial);
  const Armijo armijo(objective, point.value, slope);
  const bool accepted = armijo.holds(a, value);
  if (!accepted && (!std::isfinite(value) || armijo.flat(a))) {
    ++report.backtracks;
    return backtrack(objective, x, point.step, armijo, 0.5 * a, report);
  }
  if (!accepted) watch(x, point, slope, a);
  const bool flat = accepted && armijo.flat(a);
  trusted_ = flat ? trusted_ + 1 : 0;
  share_ = trusted_ > kTrusted ? level_share(objective, point.mode, x, point.step, slope, a) : a;
  if (share_ < a) trial = moved(objective, x, share_, point.step);
  objective.predict(x, share_ * point.step);
  x = std::move(trial);
  return flat ? Search::flat : Search::decreased;
}

void Watchdog::watch(const VecX& x, const NewtonPoint& point, double slope, double a) {
  x_ = x;
  step_ = point.step;
  value_ = point.value;
  slope_ = slope;
  a_ = a;
  left_ = kWatchedSteps;
}

Search Watchdog::turn_back(Objective& objective, VecX& x, NewtonReport& report) {
  left_ = 0;
  turned_back_ = true;
  ++turns_;
  x = x_;
  const Armijo armijo(objective, value_, slope_);
  const Search found = backtrack(objective, x, step_, armijo, 0.5 * a_, report);
  if (turns_ <= kHalved || found == Search::failed) return found;
  // Halves of a step that leads over a kink, such as where yarn sticks, are hardly lower wherever the kink is.
  const double share = level_share(objective, HessianMode::exact, x_, step_, slope_, 0.5 * a_);
  VecX trial = moved(objective, x_, share, step_);
  if (objective.value(trial) < objective.value(x)) {
    objective.predict(trial, VecX::Zero(x.size()));
    x = std::move(trial);
  }
  return found;
}

}  // namespace slipstitch
