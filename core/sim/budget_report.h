// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace slipstitch {

/// How a run with a budget of wall time used it.
struct BudgetReport {
  static constexpr double kKept = 1.1;  // times the budget, up to which it counts as kept
  double budget_s = 0.0;
  bool kept = false;
  std::optional<double> same_tolerance_m;  // with which a run takes about as long; absent: not a step was made
  double loosest_tolerance_m = 0.0;        // that it goes down to
  double share_at_loosest = 0.0;           // of the simulated time
};

}  // namespace slipstitch
