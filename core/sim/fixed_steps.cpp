// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sim/longest_step.h"
#include "sim/run.h"
#include "sim/step_control.h"

namespace slipstitch {
namespace {

class FixedSteps final : public StepControl {
 public:
  FixedSteps(const FixedNumerics& numerics, double frames_per_s)
      : numerics_(numerics),
        largest_(1.0 / frames_per_s / least_steps_per_frame(frames_per_s, numerics.time_step_s)),
        step_(largest_) {}

  Attempt attempt(Simulation& sim, double end, const ShouldStop& should_stop) override {
    const double remaining = end - sim.state().t;
    const double wanted = longest_step(sim, std::min({step_, largest_, remaining}));
    Attempt result;
    result.h = remaining / std::ceil(remaining / wanted - 1e-6);
    result.report = sim.step(result.h, numerics_, should_stop);
    result.steps = result.report.accepted ? 1 : 0;
    step_ = result.report.accepted ? std::min(largest_, 2.0 * step_) : 0.5 * result.h;
    return result;
  }
  double wanted_step() const override { return step_; }
  double smallest_step() const override { return numerics_.smallest_step_s; }

 private:
  const FixedNumerics numerics_;
  const double largest_;  // [s]
  double step_;           // asked of the next step [s]
};

}  // namespace

std::unique_ptr<StepControl> make_fixed_steps(const FixedNumerics& numerics, double frames_per_s) {
  return std::make_unique<FixedSteps>(numerics, frames_per_s);
}

std::unique_ptr<StepControl> make_step_control(const Scene& scene, const Simulation& sim,
                                               std::unique_ptr<LinearSolver> solver, const RunClock& clock) {
  if (const auto* fixed = std::get_if<FixedNumerics>(&scene.numerics))
    return make_fixed_steps(*fixed, scene.frames_per_s);
  const auto* budget = std::get_if<BudgetNumerics>(&scene.numerics);
  std::unique_ptr<PairGoal> goal =
      budget != nullptr ? make_budget_goal(*budget, scene, clock)
                        : make_tolerance_goal(std::get<AccuracyNumerics>(scene.numerics), scene.duration_s);
  return make_accurate_steps(std::move(goal), scene, sim, std::move(solver));
}

}  // namespace slipstitch
