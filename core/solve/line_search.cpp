// SPDX-License-Identifier: MIT
#include "solve/line_search.h"

#include <cmath>

namespace slipstitch {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMaxBacktracks = 40;
constexpr int kWatchedSteps = 4;

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
  objective.predict(x, a * point.step);
  x = std::move(trial);
  share_ = a;
  return accepted && armijo.flat(a) ? Search::flat : Search::decreased;
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
  x = x_;
  return backtrack(objective, x, step_, Armijo(objective, value_, slope_), 0.5 * a_, report);
}

}  // namespace slipstitch
