// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "model/scene.h"
#include "sim/pair_goal.h"
#include "sim/simulation.h"

namespace slipstitch {

/// What one attempt to go on took.
struct Attempt {
  StepReport report;  // of the last solve, with the counts of all
  double h = 0.0;     // the steps that were tried [s]
  int steps = 0;      // accepted; 0: the simulation is as it was
};

/// How far the run is from the exact motion, as far as it can tell.
struct ErrorEstimate {
  double position_m = 0.0;      // of any node, now
  double max_position_m = 0.0;  // at any frame up to now
  std::optional<double>
      lost_at_s;  // frame from which on that is beyond the tolerance, as the motion cannot be told there
};

/// How a run chooses its steps.
class StepControl {
 public:
  using ShouldStop = std::function<bool()>;
  StepControl() = default;
  StepControl(const StepControl&) = delete;
  StepControl& operator=(const StepControl&) = delete;
  virtual ~StepControl() = default;

  /// Before the first attempt: sees what the scene takes, and puts `sim` back to where it is; the counts of what that
  /// solved. `on_pair` is called now and then.
  virtual NewtonReport try_out(Simulation& sim, const ShouldStop& should_stop, const std::function<void()>& on_pair);
  /// Goes on towards `end` [s], not beyond. An attempt that is refused makes the next one shorter.
  virtual Attempt attempt(Simulation& sim, double end, const ShouldStop& should_stop) = 0;
  /// What the next step would be, were there room [s].
  virtual double wanted_step() const = 0;
  /// Shorter steps are not allowed [s].
  virtual double smallest_step() const = 0;
  virtual std::optional<ErrorEstimate> error() const { return std::nullopt; }
  /// Linear solves and seconds of simulations beside the one that is watched; null: none.
  virtual const Simulation* companion() const { return nullptr; }
  /// `kept` is not known here. None: no budget.
  virtual std::optional<BudgetReport> budget() const { return std::nullopt; }
};

inline NewtonReport StepControl::try_out(Simulation& /*sim*/, const ShouldStop& /*should_stop*/,
                                         const std::function<void()>& /*on_pair*/) {
  return {};
}

/// Equal steps of at most the asked size; one that does not converge is halved, and the size grows back by one doubling
/// an accepted step.
std::unique_ptr<StepControl> make_fixed_steps(const FixedNumerics& numerics, double frames_per_s);

/// As long as the goal allows (accurate_steps.cpp). `sim` is at its start.
std::unique_ptr<StepControl> make_accurate_steps(std::unique_ptr<PairGoal> goal, const Scene& scene,
                                                 const Simulation& sim, std::unique_ptr<LinearSolver> solver);

/// As the scene's numerics ask for it. `solver` is for a companion, if there is one; `clock` for a budget.
std::unique_ptr<StepControl> make_step_control(const Scene& scene, const Simulation& sim,
                                               std::unique_ptr<LinearSolver> solver, const RunClock& clock);

}  // namespace slipstitch
