// SPDX-License-Identifier: MIT
#include "study/study_runs.h"

#include <algorithm>

#include "sim/clock.h"
#include "study/measured_run.h"
#include "study/start_noise.h"

namespace slipstitch {
namespace {

/// Solves that a rung takes if no step is cut; of a tolerance, what steps of implicit Euler of 1/240 s take.
double work_of(const Scene& scene, const Rung& rung) {
  const auto* fixed = std::get_if<FixedNumerics>(&rung.numerics);
  const FixedNumerics numerics = fixed != nullptr ? *fixed : FixedNumerics{};
  const bool two_solves =
      numerics.integrator == Integrator::sdirk2 || numerics.integrator == Integrator::implicit_midpoint;
  constexpr double kStart = 20.0;  // what relaxing a repeat and making the model are worth
  const auto steps = static_cast<double>(least_steps(scene.duration_s, scene.frames_per_s, numerics.time_step_s));
  return kStart + (two_solves ? 2.0 : 1.0) * steps;
}

}  // namespace

StudyRun study_run(const Scene& scene, const Rung& rung, bool noise) {
  StudyRun run{with_rung(scene, rung), exact_text(rung), rung_name(rung), work_of(scene, rung), noise};
  if (noise) {
    run.key += " noise";
    run.what += ", with noise";
  }
  return run;
}

StudyRuns::StudyRuns(const WorkPrecisionOptions& options)
    : options_(options),
      own_shelf_(options.shelf == nullptr ? make_memory_shelf() : nullptr),
      shelf_(options.shelf != nullptr ? options.shelf : own_shelf_.get()),
      clock_(options.clock_s ? options.clock_s : steady_clock_s),
      start_(clock_()) {}

std::optional<KeptRun> StudyRuns::get(const StudyRun& wanted, double until_s) {
  if (ended() || asked_to_stop()) return std::nullopt;
  std::optional<KeptRun> kept = find(wanted);
  if (kept) {
    done_ += wanted.work;
    return kept;
  }
  kept = run(wanted, until_s);
  if (!kept || !keep(wanted, *kept)) return std::nullopt;
  return kept;
}

bool StudyRuns::again(const StudyRun& wanted, double until_s) {
  if (ended() || asked_to_stop()) return false;
  std::optional<KeptRun> kept = find(wanted);
  const std::optional<KeptRun> more = kept ? run(wanted, until_s) : std::nullopt;
  if (!more) return false;
  kept->wall_s.push_back(more->wall_s.front());
  kept->memory_bytes = std::min(kept->memory_bytes, more->memory_bytes);
  return keep(wanted, *kept);
}

std::optional<KeptRun> StudyRuns::run(const StudyRun& wanted, double until_s) {
  KeptRun kept;
  MeasureOptions options;
  options.threads = options_.threads;
  options.trace = &kept.trace;
  if (wanted.noise) options.on_model = [](Model& model) { add_start_noise(model, kTwinNoise_m); };
  options.should_stop = [&] { return asked_to_stop() || now() >= until_s; };
  options.on_progress = [&](double share) {
    shown_ = std::max(shown_, std::min(1.0, (done_ + share * wanted.work) / std::max(planned_, 1.0)));
    if (options_.on_progress) options_.on_progress(shown_, wanted.what);
  };
  const MeasuredRun measured = measure_run(wanted.scene, options);
  if (measured.summary.status == RunStatus::cancelled) return std::nullopt;
  done_ += wanted.work;
  kept.summary = measured.summary;
  kept.wall_s = {measured.summary.wall_s};
  kept.memory_bytes = measured.memory_bytes;
  return kept;
}

bool StudyRuns::asked_to_stop() {
  stopped_ = stopped_ || (options_.should_stop && options_.should_stop());
  return stopped_;
}

bool StudyRuns::keep(const StudyRun& run, const KeptRun& kept) {
  failure_ = shelf_->keep(run.key, kept);
  return failure_.empty();
}

}  // namespace slipstitch
