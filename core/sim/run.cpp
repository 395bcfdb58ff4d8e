// SPDX-License-Identifier: MIT
#include "sim/run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "model/check_values.h"
#include "model/effect_list.h"
#include "sim/describe_place.h"
#include "sim/monitor.h"
#include "sim/prepare.h"
#include "sim/simulation.h"
#include "sim/step_control.h"

namespace slipstitch {
namespace {

std::string short_time(double t) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", t);
  return text.data();
}

std::string fault_text(const StepReport& report) {
  switch (report.fault) {
    case StepFault::arc_floor:
      return "a segment loses its yarn";
    case StepFault::outgrown:
      return "yarn that touches something grows too fast";
    case StepFault::overshot:
      return "the second half of the step takes yarn past yarn";
    case StepFault::far_push:
      return "what scripts move sweeps yarn too far in one step";
    case StepFault::none:
      break;
  }
  return std::string(to_string(report.newton.status));
}

class Run {
 public:
  Run(const Scene& scene, int threads, const RunHooks& hooks)
      : scene_(scene), hooks_(hooks), clock_{hooks.clock ? hooks.clock : steady_clock_s, 0.0} {
    clock_.began_s = hooks.began_s ? *hooks.began_s : clock_.now();
    summary_.scene = scene.name;
    summary_.threads = threads;
  }

  RunSummary go() {
    Prepared prepared = prepare(scene_, hooks_.should_stop);
    if (prepared.cancelled) return finish(RunStatus::cancelled, "");
    if (prepared.failure) return finish(RunStatus::failed, *prepared.failure);
    if (hooks_.on_model) hooks_.on_model(prepared.model);
    Simulation sim(std::move(prepared.model), new_solver());
    if (hooks_.on_start) hooks_.on_start(sim);
    Monitor monitor(sim);
    HandleForces forces(sim, scene_.handles.size());
    describe(sim);
    control_ = make_step_control(scene_, sim, new_solver(), clock_);
    begin(sim);
    try_out(sim);
    const RunStatus status = march(sim, monitor, forces);
    monitor.report(sim, summary_);
    summary_.handles = forces.report();
    summary_.nonzeros = std::max<long>(summary_.nonzeros, sim.num_nonzeros());
    summary_.bodies = body_motions(sim);
    summary_.effect_cost = sim.effect_costs();
    summary_.energy_j = sim.energies();
    summary_.wall_by_phase_s = wall_by_phase(sim);
    summary_.linear_iterations = linear_solves(sim);
    if (const auto error = control_->error()) {
      summary_.error_estimate_m = error->max_position_m;
      summary_.predictable_until_s = error->lost_at_s;
    }
    summary_.budget = control_->budget();
    summary_.state_hash = state_hash(sim.state().q);
    summary_.sim_time_s = time(sim);
    return finish(status, summary_.message);
  }

 private:
  std::unique_ptr<LinearSolver> new_solver() const {
    return hooks_.make_solver ? hooks_.make_solver() : make_cholmod_solver();
  }

  long linear_solves(const Simulation& sim) const {
    const Simulation* companion = control_->companion();
    return sim.linear_solves() + (companion != nullptr ? companion->linear_solves() : 0);
  }

  std::map<std::string, double> wall_by_phase(const Simulation& sim) const {
    std::map<std::string, double> wall = sim.wall_by_phase_s();
    if (const Simulation* companion = control_->companion())
      for (const auto& [phase, seconds] : companion->wall_by_phase_s()) wall[phase] += seconds;
    return wall;
  }

  std::optional<double> error_now() const {
    const auto error = control_->error();
    return error ? std::optional(error->position_m) : std::nullopt;
  }

  double wall() const { return clock_.wall_s(); }

  std::optional<double> budget() const {
    const auto* numerics = std::get_if<BudgetNumerics>(&scene_.numerics);
    return numerics != nullptr ? std::optional(numerics->budget_s) : std::nullopt;
  }

  RunSummary finish(RunStatus status, const std::string& message) {
    summary_.status = status;
    summary_.message = message;
    summary_.wall_s = wall();
    if (summary_.budget) summary_.budget->kept = summary_.wall_s <= BudgetReport::kKept * summary_.budget->budget_s;
    return summary_;
  }

  void describe(const Simulation& sim) {
    const Topology& topo = sim.model().topology;
    summary_.loops = static_cast<int>(topo.stitches.size());
    summary_.nodes = topo.num_nodes;
    summary_.dofs = sim.num_dofs();
    summary_.nonzeros = sim.num_nonzeros();
    summary_.effects = effect_names(scene_.effects);
    summary_.linear_solver = sim.solver_name();
    summary_.residual_unit = sim.quasi_static() ? "N" : "m/s";
    num_frames_ = planned_frames(scene_.duration_s, scene_.frames_per_s);
  }

  void begin(const Simulation& sim) {
    const auto& shrinkage = scene_.effects.shrinkage;
    if (hooks_.on_header) {
      hooks_.on_header({sim.model().topology, sim.model().yarn, scene_.frames_per_s, num_frames_,
                        shrinkage ? shrinkage->keyframes : std::vector<LengthKeyframe>()});
    }
    emit(sim);
    trace_bodies(sim);
  }

  /// The time of its state; where a frame's planned time is reached but for rounding, that.
  double time(const Simulation& sim) const {
    return std::abs(sim.state().t - frame_end_) <= rounding() ? frame_end_ : sim.state().t;
  }

  double rounding() const { return 1e-9 / scene_.frames_per_s; }

  void emit(const Simulation& sim) {
    if (hooks_.on_frame) hooks_.on_frame({summary_.frames, time(sim), sim.state().q});
    if (hooks_.on_frame_report) hooks_.on_frame_report(report(sim));
    ++summary_.frames;
    last_emitted_ = time(sim);
  }

  FrameReport report(const Simulation& sim) const {
    FrameReport report;
    report.frame = summary_.frames;
    report.t = time(sim);
    report.steps = summary_.steps;
    report.rejected_steps = summary_.rejected_steps;
    report.newton_iterations = summary_.newton_iterations;
    report.linear_iterations = linear_solves(sim);
    report.error_estimate_m = error_now();
    if (summary_.steps > 0) {
      report.step_s = last_step_;
      report.residual = last_residual_;
    }
    report.energy_j = reported_energies(sim);
    return report;
  }

  void progress(const Simulation& sim, double h, double residual) const {
    if (!hooks_.on_progress) return;
    Progress p;
    p.t = time(sim);
    p.duration_s = scene_.duration_s;
    p.frames = summary_.frames;
    p.num_frames = num_frames_;
    p.steps = summary_.steps;
    p.newton_iterations = summary_.newton_iterations;
    p.step_s = h;
    p.residual = residual;
    p.error_estimate_m = error_now();
    p.wall_s = wall();
    p.wall_by_phase_s = wall_by_phase(sim);
    p.budget_s = budget();
    p.before_s = before_;
    hooks_.on_progress(p);
  }

  /// What the scene takes, where a budget must know. Frames, steps and the watch over them begin behind it.
  void try_out(Simulation& sim) {
    const auto tell = [&] {
      if (!hooks_.on_progress) return;
      Progress p;
      p.duration_s = scene_.duration_s;
      p.frames = summary_.frames;
      p.num_frames = num_frames_;
      p.wall_s = p.before_s = wall();
      p.budget_s = budget();
      p.doing = "trying what fits into " + number_text(*budget()) + " s";
      hooks_.on_progress(p);
    };
    count(control_->try_out(sim, hooks_.should_stop, tell));
    if (budget()) before_ = wall();
  }

  void trace_bodies(const Simulation& sim) const {
    if (!hooks_.on_bodies || sim.model().bodies.empty()) return;
    std::vector<Vec3> centres;
    for (const BodyMotion& body : body_motions(sim)) centres.push_back(body.position_m);
    hooks_.on_bodies(time(sim), centres);
  }

  void measure(const Simulation& sim, HandleForces& forces) const {
    if (forces.empty()) return;
    const std::vector<Vec3>& now = forces.observe(sim);
    if (hooks_.on_reactions) hooks_.on_reactions(time(sim), now);
  }

  RunStatus march(Simulation& sim, Monitor& monitor, HandleForces& forces) {
    for (int frame = 1; frame < num_frames_; ++frame) {
      const double end = std::min(frame / scene_.frames_per_s, scene_.duration_s);
      frame_end_ = end;
      const RunStatus status = advance_to(sim, monitor, forces, end);
      if (status != RunStatus::succeeded) {
        // The last good state, between the frames that were planned.
        if (status == RunStatus::failed && sim.state().t > last_emitted_ + rounding()) emit(sim);
        return status;
      }
      emit(sim);
      progress(sim, control_->wanted_step(), last_residual_);
    }
    return RunStatus::succeeded;
  }

  std::string why_not(const Simulation& sim, const StepReport& report) const {
    std::string why = "no step above " + number_text(control_->smallest_step()) +
                      " s converges at t = " + short_time(sim.state().t) + " s: " + fault_text(report);
    if (report.worst_coord < 0) return why;
    if (report.fault == StepFault::none && report.newton.status == NewtonStatus::not_finite)
      return why + ": " + report.worst_term + " leaves no room for " +
             describe_coordinate(sim.model().topology, report.worst_coord);
    why += ", worst at " + describe_coordinate(sim.model().topology, report.worst_coord);
    return report.worst_term.empty() ? why : why + ", where the largest force is that of " + report.worst_term;
  }

  void count(const NewtonReport& newton) {
    summary_.newton_iterations += newton.iterations;
    summary_.factorizations += newton.factorizations;
    summary_.cg_iterations += newton.cg_iterations;
    summary_.convex_hessians += newton.convex_hessians;
  }

  RunStatus advance_to(Simulation& sim, Monitor& monitor, HandleForces& forces, double end) {
    while (end - sim.state().t > rounding()) {
      const Attempt attempt = control_->attempt(sim, end, hooks_.should_stop);
      const StepReport& report = attempt.report;
      count(report.newton);
      if (report.newton.status == NewtonStatus::cancelled) return RunStatus::cancelled;
      if (hooks_.on_step) hooks_.on_step(sim, report);
      if (attempt.steps == 0) {
        ++summary_.rejected_steps;
        if (control_->wanted_step() >= control_->smallest_step()) continue;
        summary_.message = why_not(sim, report);
        return RunStatus::failed;
      }
      summary_.steps += attempt.steps;
      last_residual_ = report.residual;
      last_step_ = attempt.h;
      measure(sim, forces);
      trace_bodies(sim);
      if (const auto stop = monitor.observe(sim, report.residual)) {
        summary_.message = *stop;
        return RunStatus::failed;
      }
      progress(sim, attempt.h, report.residual);
      if (hooks_.should_stop && hooks_.should_stop()) return RunStatus::cancelled;
    }
    return RunStatus::succeeded;
  }

  const Scene& scene_;
  const RunHooks& hooks_;
  RunClock clock_;
  RunSummary summary_;
  int num_frames_ = 0;
  std::unique_ptr<StepControl> control_;
  double last_residual_ = 0.0;
  double last_step_ = 0.0;     // accepted [s]
  double before_ = 0.0;        // wall time of what came before the simulation itself [s]
  double last_emitted_ = 0.0;  // time of the last frame [s]
  double frame_end_ = 0.0;     // planned, of the frame it is on its way to [s]
};

}  // namespace

int planned_frames(double duration_s, double frames_per_s) {
  return 1 + static_cast<int>(std::ceil(duration_s * frames_per_s - 1e-9));
}

double least_steps_per_frame(double frames_per_s, double time_step_s) {
  return std::ceil(1.0 / frames_per_s / time_step_s * (1.0 - 1e-6));
}

long least_steps(double duration_s, double frames_per_s, double time_step_s) {
  const int frames = planned_frames(duration_s, frames_per_s);
  if (frames < 2) return 0;
  const double a_frame = least_steps_per_frame(frames_per_s, time_step_s);
  const double last = (duration_s * frames_per_s - (frames - 2)) * a_frame;  // the last frame may come early
  return static_cast<long>(a_frame * (frames - 2) + std::ceil(last - 1e-6));
}

RunSummary run(const Scene& scene, int threads, const RunHooks& hooks) {
  if (scene.effects.automatic) {
    RunSummary summary;
    summary.scene = scene.name;
    summary.message = "effects.auto stands, whose choice must be made first";
    return summary;
  }
  return Run(scene, threads, hooks).go();
}

}  // namespace slipstitch
