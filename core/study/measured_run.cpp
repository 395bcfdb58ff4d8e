// SPDX-License-Identifier: MIT
#include "study/measured_run.h"

#include <algorithm>
#include <cmath>

#include "sim/simulation.h"
#include "study/heap.h"

namespace slipstitch {
namespace {

constexpr double kComparedRadii = 0.1;  // tolerance of a scene with a budget

class DifferenceSum {
 public:
  void add(const VecX& x, const VecX& reference) {
    const Eigen::Index coords = std::min(x.size(), reference.size());
    for (Eigen::Index i = 0; i < coords; i += 3) {
      const double square = (x.segment<3>(i) - reference.segment<3>(i)).squaredNorm();
      largest_ = std::max(largest_, square);
      sum_ += square;
    }
    count_ += static_cast<double>(coords) / 3.0;
  }
  double largest() const { return std::sqrt(largest_); }
  FrameDifference result() const { return {largest(), count_ > 0.0 ? std::sqrt(sum_ / count_) : 0.0}; }

 private:
  double largest_ = 0.0, sum_ = 0.0, count_ = 0.0;
};

double stored_energy(const RunSummary& summary) {
  double sum = 0.0;
  for (const auto& [term, energy] : summary.energy_j)
    if (term != "kinetic" && !is_weight_or_load(term)) sum += energy;
  return sum;
}

void derive_forces(const Scene& scene, MeasuredRun& run) {
  run.stored_j = stored_energy(run.summary);
  if (scene.effects.stretch && run.summary.max_stretch) {
    run.tension_n = std::max(0.0, scene.yarn.stretch_n * (*run.summary.max_stretch - 1.0));
  }
  for (const HandleForce& handle : run.summary.handles) {
    if (std::isfinite(handle.max_reaction_n)) run.reaction_n = std::max(run.reaction_n, handle.max_reaction_n);
  }
}

/// Runs that each take the time they are given cannot be compared by their time.
Scene comparable(Scene scene) {
  if (std::holds_alternative<BudgetNumerics>(scene.numerics))
    scene.numerics =
        AccuracyNumerics{std::max(kComparedRadii * scene.yarn.radius_m, AccuracyNumerics::kLeastTolerance_m)};
  return scene;
}

/// Adds what a trace takes to the hooks.
void trace_frames(FrameTracer& tracer, RunHooks& hooks) {
  hooks.on_header = [&tracer, then = hooks.on_header](const FrameHeader& header) {
    tracer.on_header(header);
    then(header);
  };
  hooks.on_frame = [&tracer, then = hooks.on_frame](const Frame& frame) {
    tracer.on_frame(frame);
    then(frame);
  };
  hooks.on_frame_report = [&tracer](const FrameReport& report) { tracer.on_frame_report(report); };
  hooks.on_reactions = [&tracer](double, const std::vector<Vec3>& reactions) { tracer.on_reactions(reactions); };
}

}  // namespace

MeasuredRun measure_run(const Scene& given, const MeasureOptions& options) {
  const Scene scene = comparable(given);
  MeasuredRun measured;
  DifferenceSum difference;
  double recorded = 0.0;
  const double before = heap_in_use();
  Eigen::Index position_coords = 0;
  double nonzeros = 0.0;
  const auto goes_too_far = [&] {
    return (options.max_effort > 0 && measured.effort > options.max_effort) ||
           (options.max_cost > 0.0 && static_cast<double>(measured.effort) * nonzeros > options.max_cost) ||
           (options.max_difference_m > 0.0 && difference.largest() > options.max_difference_m);
  };
  RunHooks hooks;
  hooks.on_header = [&](const FrameHeader& header) { position_coords = 3 * header.topology.num_nodes; };
  hooks.on_frame = [&](const Frame& frame) {
    const auto index = static_cast<std::size_t>(frame.index);
    const VecX x = frame.q.head(position_coords);
    if (options.reference && index < options.reference->x.size()) difference.add(x, options.reference->x[index]);
    if (!options.record) return;
    options.record->x.push_back(x);
    recorded += static_cast<double>(x.size()) * sizeof(double);
  };
  hooks.on_progress = [&](const Progress& progress) {
    const double traced = options.trace != nullptr ? bytes_of(*options.trace) : 0.0;
    measured.memory_bytes = std::max(0.0, heap_in_use() - before - recorded - traced);
    if (options.on_progress && progress.duration_s > 0.0) options.on_progress(progress.t / progress.duration_s);
  };
  hooks.should_stop = [&] {
    ++measured.effort;
    return goes_too_far() || (options.should_stop && options.should_stop());
  };
  hooks.on_start = [&](Simulation& sim) { nonzeros = sim.num_nonzeros(); };
  hooks.on_model = options.on_model;
  std::optional<FrameTracer> tracer;
  if (options.trace != nullptr) trace_frames(tracer.emplace(scene, *options.trace), hooks);
  measured.summary = run(scene, options.threads, hooks);
  measured.difference = difference.result();
  derive_forces(scene, measured);
  return measured;
}

}  // namespace slipstitch
