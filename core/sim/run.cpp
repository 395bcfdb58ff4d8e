// SPDX-License-Identifier: MIT
#include "sim/run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "model/check_values.h"
#include "model/effect_list.h"
#include "sim/describe_place.h"
#include "sim/longest_step.h"
#include "sim/monitor.h"
#include "sim/prepare.h"
#include "sim/simulation.h"

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
  Run(const Scene& scene, const FixedNumerics& numerics, int threads, const RunHooks& hooks)
      : scene_(scene), numerics_(numerics), hooks_(hooks), start_(std::chrono::steady_clock::now()) {
    summary_.scene = scene.name;
    summary_.threads = threads;
  }

  RunSummary go() {
    Prepared prepared = prepare(scene_, hooks_.should_stop);
    if (prepared.cancelled) return finish(RunStatus::cancelled, "");
    if (prepared.failure) return finish(RunStatus::failed, *prepared.failure);
    if (hooks_.on_model) hooks_.on_model(prepared.model);
    Simulation sim(std::move(prepared.model), hooks_.make_solver ? hooks_.make_solver() : make_cholmod_solver());
    if (hooks_.on_start) hooks_.on_start(sim);
    Monitor monitor(sim);
    HandleForces forces(sim, scene_.handles.size());
    describe(sim);
    begin(sim);
    const RunStatus status = march(sim, monitor, forces);
    monitor.report(sim, summary_);
    summary_.handles = forces.report();
    summary_.nonzeros = std::max<long>(summary_.nonzeros, sim.num_nonzeros());
    summary_.bodies = body_motions(sim);
    summary_.effect_cost = sim.effect_costs();
    summary_.energy_j = sim.energies();
    summary_.wall_by_phase_s = sim.wall_by_phase_s();
    summary_.linear_iterations = sim.linear_solves();
    summary_.state_hash = state_hash(sim.state().q);
    summary_.sim_time_s = sim.state().t;
    return finish(status, summary_.message);
  }

 private:
  double wall() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  RunSummary finish(RunStatus status, const std::string& message) {
    summary_.status = status;
    summary_.message = message;
    summary_.wall_s = wall();
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

  void emit(const Simulation& sim) {
    if (hooks_.on_frame) hooks_.on_frame({summary_.frames, sim.state().t, sim.state().q});
    if (hooks_.on_frame_report) hooks_.on_frame_report(report(sim));
    ++summary_.frames;
    last_emitted_ = sim.state().t;
  }

  FrameReport report(const Simulation& sim) const {
    FrameReport report;
    report.frame = summary_.frames;
    report.t = sim.state().t;
    report.steps = summary_.steps;
    report.rejected_steps = summary_.rejected_steps;
    report.newton_iterations = summary_.newton_iterations;
    report.linear_iterations = sim.linear_solves();
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
    p.t = sim.state().t;
    p.duration_s = scene_.duration_s;
    p.frames = summary_.frames;
    p.num_frames = num_frames_;
    p.steps = summary_.steps;
    p.newton_iterations = summary_.newton_iterations;
    p.step_s = h;
    p.residual = residual;
    p.wall_s = wall();
    hooks_.on_progress(p);
  }

  void trace_bodies(const Simulation& sim) const {
    if (!hooks_.on_bodies || sim.model().bodies.empty()) return;
    std::vector<Vec3> centres;
    for (const BodyMotion& body : body_motions(sim)) centres.push_back(body.position_m);
    hooks_.on_bodies(sim.state().t, centres);
  }

  void measure(const Simulation& sim, HandleForces& forces) const {
    if (forces.empty()) return;
    const std::vector<Vec3>& now = forces.observe(sim);
    if (hooks_.on_reactions) hooks_.on_reactions(sim.state().t, now);
  }

  RunStatus march(Simulation& sim, Monitor& monitor, HandleForces& forces) {
    for (int frame = 1; frame < num_frames_; ++frame) {
      const double end = std::min(frame / scene_.frames_per_s, scene_.duration_s);
      const RunStatus status = advance_to(sim, monitor, forces, end);
      if (status != RunStatus::succeeded) {
        // The last good state, between the frames that were planned.
        if (status == RunStatus::failed && sim.state().t > last_emitted_) emit(sim);
        return status;
      }
      emit(sim);
      progress(sim, step_, last_residual_);
    }
    return RunStatus::succeeded;
  }

  std::string why_not(const Simulation& sim, const StepReport& report) const {
    std::string why = "no step above " + number_text(numerics_.smallest_step_s) +
                      " s converges at t = " + short_time(sim.state().t) + " s: " + fault_text(report);
    if (report.worst_coord < 0) return why;
    if (report.fault == StepFault::none && report.newton.status == NewtonStatus::not_finite)
      return why + ": " + report.worst_term + " leaves no room for " +
             describe_coordinate(sim.model().topology, report.worst_coord);
    why += ", worst at " + describe_coordinate(sim.model().topology, report.worst_coord);
    return report.worst_term.empty() ? why : why + ", where the largest force is that of " + report.worst_term;
  }

  /// Equal steps of at most the asked size up to time `end`; a step that does not converge is halved, and the size
  /// grows back by one doubling an accepted step.
  RunStatus advance_to(Simulation& sim, Monitor& monitor, HandleForces& forces, double end) {
    const double frame = 1.0 / scene_.frames_per_s;
    const double largest = frame / least_steps_per_frame(scene_.frames_per_s, numerics_.time_step_s);
    if (step_ == 0.0) step_ = largest;
    while (end - sim.state().t > 1e-9 * frame) {
      const double remaining = end - sim.state().t;
      const double wanted = longest_step(sim, std::min({step_, largest, remaining}));
      const double h = remaining / std::ceil(remaining / wanted - 1e-6);
      const StepReport report = sim.step(h, numerics_, hooks_.should_stop);
      summary_.newton_iterations += report.newton.iterations;
      summary_.factorizations += report.newton.factorizations;
      summary_.cg_iterations += report.newton.cg_iterations;
      summary_.convex_hessians += report.newton.convex_hessians;
      if (report.newton.status == NewtonStatus::cancelled) return RunStatus::cancelled;
      if (hooks_.on_step) hooks_.on_step(sim, report);
      if (!report.accepted) {
        ++summary_.rejected_steps;
        step_ = 0.5 * h;
        if (step_ >= numerics_.smallest_step_s) continue;
        summary_.message = why_not(sim, report);
        return RunStatus::failed;
      }
      ++summary_.steps;
      last_residual_ = report.residual;
      last_step_ = h;
      step_ = std::min(largest, 2.0 * step_);
      measure(sim, forces);
      trace_bodies(sim);
      if (const auto stop = monitor.observe(sim, report.residual)) {
        summary_.message = *stop;
        return RunStatus::failed;
      }
      progress(sim, h, report.residual);
      if (hooks_.should_stop && hooks_.should_stop()) return RunStatus::cancelled;
    }
    return RunStatus::succeeded;
  }

  const Scene& scene_;
  const FixedNumerics& numerics_;
  const RunHooks& hooks_;
  std::chrono::steady_clock::time_point start_;
  RunSummary summary_;
  int num_frames_ = 0;
  double step_ = 0.0, last_residual_ = 0.0;  // step: size asked of the next step [s]
  double last_step_ = 0.0;                   // accepted [s]
  double last_emitted_ = 0.0;                // time of the last frame [s]
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
  const auto* numerics = std::get_if<FixedNumerics>(&scene.numerics);
  if (numerics == nullptr || scene.effects.automatic) {
    RunSummary summary;
    summary.scene = scene.name;
    summary.message = numerics == nullptr ? "accuracy numerics are not supported yet"
                                          : "effects.auto stands, whose choice must be made first";
    return summary;
  }
  return Run(scene, *numerics, threads, hooks).go();
}

}  // namespace slipstitch
