// SPDX-License-Identifier: MIT
#include "study/pilot.h"

#include <algorithm>
#include <memory>

#include "sim/run.h"
#include "sim/simulation.h"

namespace slipstitch {
namespace {

/// What the solvers of one run know of their matrix.
struct Analysis {
  std::optional<FactorSize> size;
  double first_s = 0.0;  // of the first factorisation of each solver, which begins with the symbolic analysis
  double later_s = 0.0;  // of all others
};

class PilotSolver final : public LinearSolver {
 public:
  PilotSolver(Analysis& analysis, const Clock& clock) : analysis_(analysis), clock_(clock) {}
  LinearStatus factor(const SparseMatrix& a) override {
    const double start = clock_();
    const LinearStatus status = inner_->factor(a);
    (analysed_ ? analysis_.later_s : analysis_.first_s) += clock_() - start;
    if (analysed_) return status;
    analysis_.size = inner_->factor_size();
    analysed_ = true;
    return status;
  }
  LinearStatus solve(const VecX& b, VecX& x) override { return inner_->solve(b, x); }
  std::string name() const override { return inner_->name(); }

 private:
  std::unique_ptr<LinearSolver> inner_ = make_cholmod_solver();
  Analysis& analysis_;
  const Clock& clock_;
  bool analysed_ = false;
};

}  // namespace

Pilot run_pilot(const Scene& scene, const PilotLimits& limits, const Clock& clock) {
  Pilot pilot;
  Analysis analysis;
  const double begin = clock();
  double first_step = begin, last_step = begin;
  long iterations = 0;
  const auto spent = [&] {
    pilot.size.factor = analysis.size.value_or(FactorSize{});
    const double modelled = static_cast<double>(iterations) * iteration_s(limits.cost, pilot.size);
    return modelled > limits.wall_s || clock() - first_step > limits.wall_s;
  };
  RunHooks hooks;
  hooks.make_solver = [&] { return std::make_unique<PilotSolver>(analysis, clock); };
  hooks.on_start = [&](Simulation& sim) {
    pilot.size.dofs = sim.num_dofs();
    pilot.size.nonzeros = sim.num_nonzeros();
    first_step = last_step = clock();
  };
  hooks.on_progress = [&](const Progress& now) {
    if (!pilot.course.empty() && now.t <= pilot.course.back().t) return;
    pilot.course.push_back({now.t, static_cast<double>(now.steps), static_cast<double>(now.newton_iterations)});
    last_step = clock();
  };
  hooks.should_stop = [&] {
    ++iterations;
    return spent();
  };
  const RunSummary summary = run(scene, 1, hooks);
  pilot.finished = summary.status == RunStatus::succeeded;
  if (summary.status == RunStatus::failed) pilot.failure = summary.message;
  pilot.setup_s = first_step - begin + analysis.first_s;
  pilot.factor_s = analysis.later_s;
  pilot.wall_s = std::max(0.0, last_step - first_step - analysis.first_s);
  return pilot;
}

}  // namespace slipstitch
