// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "sim/run.h"
#include "sim/simulation.h"

namespace slipstitch {

/// Watches the accepted steps of one run for what the summary reports and for the ends of the model's validity.
class Monitor {
 public:
  explicit Monitor(const Simulation& sim);

  /// Call after every accepted step. Returns why the run cannot go on, if so.
  std::optional<std::string> observe(const Simulation& sim, double residual);
  /// Fills the measured fields of the summary.
  void report(const Simulation& sim, RunSummary& summary) const;

 private:
  void observe_segments(const Simulation& sim);
  void observe_wraps(const Simulation& sim);
  std::optional<std::string> pulled_out(const Simulation& sim) const;

  VecX start_arc_;             // (num_visits)
  std::vector<char> in_cap_;   // per wrap, after the last step
  std::vector<char> faded_;    // the same
  std::vector<char> crushed_;  // per visit, likewise
  double min_gap_ratio_, max_stretch_ = 0.0;
  double residual_ = std::numeric_limits<double>::quiet_NaN();  // before the first step
  long ridge_entries_ = 0, fade_entries_ = 0, crushed_entries_ = 0;
};

/// FNV-1a over the bytes of the full coordinates, as 16 hex digits.
std::string state_hash(const VecX& q);

}  // namespace slipstitch
