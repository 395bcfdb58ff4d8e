// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "study/work_precision.h"

namespace slipstitch {

/// Of rungs method by method: what their errors fall with from one to the next, where both are resolved. Not of static
/// ones, which have several tolerances a step.
void set_orders(std::vector<RungResult>& rungs);

/// The rungs with errors of which no other is both faster and more accurate: on_front.
void mark_front(std::vector<RungResult>& rungs);

/// What the baseline takes to every rung's error, over what the rung takes: speedup and speedup_most. Between the
/// baseline's own rungs that is interpolated in logarithms, over those that no other of them beats; beyond them the
/// time goes with 1 / error, as of a method of first order whose steps all take the same.
void compare_with_baseline(std::vector<RungResult>& rungs);

/// The program's own way, runs to a tolerance, beside the baseline with steps of a millisecond.
struct DefaultGain {
  double error_m = 0.0;                      // of both
  double baseline_s = 0.0, default_s = 0.0;  // that they take to it
  bool baseline_extrapolated = false;        // as in compare_with_baseline()
};

/// At `share` of the error of that baseline. The default's time is interpolated as the baseline's is; where even its
/// coarsest run is more accurate it is that run's. None: a run is missing, or none of the default's is so accurate.
std::optional<DefaultGain> default_gain(const std::vector<RungResult>& rungs, double share);

/// What ten times less error costs along the marked front: from every power of ten to the next within it, in logarithms
/// between its rungs, of which those that are not resolved do not count.
std::vector<DigitPrice> digit_prices(const std::vector<RungResult>& rungs);

/// The mean of that over the whole front; none where it spans less than half a digit.
std::optional<double> mean_digit_factor(const std::vector<RungResult>& rungs);

}  // namespace slipstitch
