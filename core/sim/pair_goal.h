// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "model/scene.h"
#include "sim/budget_report.h"
#include "sim/clock.h"

namespace slipstitch {

/// A pair of steps that was accepted (accurate_steps.cpp).
struct PairDone {
  double end_s = 0.0, length_s = 0.0;  // simulated
  double error_m = 0.0;                // of the pair itself
  double run_error_m = 0.0;            // of the run, at its end
};

/// What a run is after, told as what its next pair of steps may be off by.
class PairGoal {
 public:
  PairGoal() = default;
  PairGoal(const PairGoal&) = delete;
  PairGoal& operator=(const PairGoal&) = delete;
  virtual ~PairGoal() = default;

  virtual double pair_tolerance_m() const = 0;
  /// For the run as a whole, as it stands.
  virtual double tolerance_m() const = 0;
  /// Errors of the run beyond say that the motion cannot be told.
  virtual double lost_m() const = 0;
  virtual void learn(const PairDone& done) = 0;
  /// Whether what pairs may be off by falls in jumps, so that the next one cannot go by the last.
  virtual bool jumps() const { return false; }
  /// Whether it still wants pairs that do not count, from the start on, to see what the scene takes.
  virtual bool on_trial() const { return false; }
  virtual void end_trial() {}
  virtual std::optional<BudgetReport> budget() const { return std::nullopt; }
};

std::unique_ptr<PairGoal> make_tolerance_goal(const AccuracyNumerics& numerics, double duration_s);

/// Wall time of a run by a clock.
struct RunClock {
  Clock now;             // never empty
  double began_s = 0.0;  // by it
  double wall_s() const { return now() - began_s; }
};

/// Of a run with a budget: ten radii of the yarn, at which one pair may be off by a radius. Beyond, a pair could not
/// tell on which side of it another yarn lies.
double loosest_tolerance_m(double yarn_radius_m);

/// Pairs of steps as exact as fit into the time: what is to go is foreseen from a trial in the loosest pairs, of a
/// tenth of the time at most, and from what pairs take on the way, and after each pair the tolerance is set so that it
/// fits, between the loosest and AccuracyNumerics::kLeastTolerance_m.
std::unique_ptr<PairGoal> make_budget_goal(const BudgetNumerics& numerics, const Scene& scene, const RunClock& clock);

}  // namespace slipstitch
