// SPDX-License-Identifier: MIT
#include "study/reference_search.h"

#include <algorithm>
#include <cmath>

#include "study/compare_rungs.h"

namespace slipstitch {
namespace {

constexpr int kMostRuns = 5, kMostQuickRuns = 3;
constexpr double kFirstTolerance = 1e-2, kNextTolerance = 0.25;  // of the rungs' Newton tolerance; of the one before
constexpr double kNextCost = 2.2;                                // of the one before
constexpr double kSettledShare = 0.1;                            // of the smallest error of any rung
constexpr double kLeastOrder = 0.8, kMostOrder = 2.3;            // that an error is extrapolated by

bool has_result(const RungResult& result) { return result.no_result.empty(); }

/// The last one, the finest, of the method; null: there is none.
const RungResult* finest(const std::vector<RungResult>& rungs, std::string_view method, bool with_result) {
  const auto found = std::find_if(rungs.rbegin(), rungs.rend(), [&](const RungResult& r) {
    return r.rung.method == method && (!with_result || has_result(r));
  });
  return found != rungs.rend() ? &*found : nullptr;
}

double smallest_step(const std::vector<RungResult>& rungs, double otherwise) {
  double step = otherwise;
  for (const RungResult& result : rungs)
    if (has_result(result) && result.rung.method != kAccuracyMethod) step = std::min(step, result.rung.size);
  return step;
}

class Search {
 public:
  Search(const Scene& scene, const std::vector<RungResult>& rungs, StudyRuns& runs, double until_s)
      : scene_(scene), rungs_(rungs), runs_(runs), until_s_(until_s) {}

  FoundReference go(int most_runs) {
    start();
    for (int k = 0; k < most_runs && !runs_.ended() && !settled_ && !at_noise_; ++k) {
      const bool fits = k == 0 || runs_.fits(2.0 * kNextCost * last_wall_s_, until_s_);
      if (!fits && !runs_.find(study_run(scene_, rung_at(k)))) {
        found_.facts.out_of_time = true;
        break;
      }
      if (!refine(k)) break;
      if (!found_.facts.twin_step_s) run_twin();
      judge();
    }
    if (found_.facts.twin_step_s != found_.facts.step_s) run_twin();
    return std::move(found_);
  }

 private:
  void start() {
    const std::string_view method = scene_.effects.inertia ? "SDIRK2" : kStaticMethod;
    const RungResult* before = finest(rungs_, method, true);
    first_ = (before != nullptr ? before : finest(rungs_, method, false))->rung;
    const double step = smallest_step(rungs_, first_.size);
    if (before != nullptr)
      if (auto kept = runs_.find(study_run(scene_, first_))) last_trace_ = std::move(kept->trace);
    found_.first_is_halved = step > 0.99 * first_.size;
    step_factor_ = 0.5 * step / first_.size;
    found_.facts.method = first_.method;
  }

  Rung rung_at(int k) const {
    return refined(first_, step_factor_ * std::pow(0.5, k), kFirstTolerance * std::pow(kNextTolerance, k));
  }

  /// False: the time has come, or no finer one runs.
  bool refine(int k) {
    const Rung rung = rung_at(k);
    std::optional<KeptRun> kept = runs_.get(study_run(scene_, rung), until_s_);
    if (!kept) {
      found_.facts.out_of_time = !runs_.ended();
      if (found_.trace.t.empty()) found_.facts.failure = "there was no time for it";
      return false;
    }
    if (kept->summary.status != RunStatus::succeeded) {
      if (found_.trace.t.empty()) found_.facts.failure = kept->summary.message;
      return found_.trace.t.empty();
    }
    found_.facts.failure.clear();
    last_ = rung;
    last_wall_s_ = kept->wall_s.front();
    found_.facts.step_s = rung.size;
    found_.facts.wall_s = last_wall_s_;
    found_.facts.refinements = k + 1;
    found_.trace = std::move(kept->trace);
    if (!last_trace_.t.empty()) found_.change_m.push_back(difference(found_.trace, last_trace_).max_m);
    last_trace_ = found_.trace;
    return true;
  }

  void judge() {
    if (found_.change_m.empty()) return;
    const RungDifferences differences = compare_rungs(scene_, rungs_, runs_, found_.trace);
    const Horizon horizon = common_horizon(differences, found_.parting_m, least_error(scene_));
    if (horizon.frames < 2) return;  // nothing to compare but the start
    const double change = largest(found_.change_m.back(), horizon.frames);
    settled_ = change <= kSettledShare * smallest_error(differences, horizon).value_or(0.0);
    at_noise_ = !found_.parting_m.empty() && change <= largest(found_.parting_m, horizon.frames);
  }

  void run_twin() {
    if (found_.trace.t.empty()) return;
    const std::optional<KeptRun> twin = runs_.get(study_run(scene_, last_, true), until_s_);
    if (!twin || twin->summary.status != RunStatus::succeeded) return;
    found_.parting_m = difference(twin->trace, found_.trace).max_m;
    found_.facts.twin_step_s = last_.size;
    found_.facts.twin_distance_m = largest(found_.parting_m, found_.parting_m.size());
  }

  const Scene& scene_;
  const std::vector<RungResult>& rungs_;
  StudyRuns& runs_;
  const double until_s_;
  Rung first_, last_;
  bool settled_ = false, at_noise_ = false;
  double step_factor_ = 0.5, last_wall_s_ = 0.0;
  FrameTrace last_trace_;
  FoundReference found_;
};

}  // namespace

double least_error(const Scene& scene) {
  return std::max(kFinestErrorShare * scene.yarn.radius_m, 30.0 * kTwinNoise_m);
}

FoundReference find_reference(const Scene& scene, const std::vector<RungResult>& rungs, StudyRuns& runs, bool quick,
                              double until_s) {
  return Search(scene, rungs, runs, until_s).go(quick ? kMostQuickRuns : kMostRuns);
}

void set_reference_error(FoundReference& reference, std::size_t frames, double smallest_m) {
  StudyReference& facts = reference.facts;
  facts.change_m.clear();
  for (const std::vector<double>& change : reference.change_m) facts.change_m.push_back(largest(change, frames));
  const std::size_t count = facts.change_m.size();
  if (count == 0 || frames < 2) return;
  const double last = facts.change_m.back();
  facts.error_m = last;
  facts.settled = last <= kSettledShare * smallest_m;
  facts.at_noise = !reference.parting_m.empty() && last <= largest(reference.parting_m, frames);
  if (count < (reference.first_is_halved ? 2 : 3) || last <= 0.0) return;
  facts.order = std::log2(facts.change_m[count - 2] / last);
  facts.extrapolated = *facts.order >= kLeastOrder && *facts.order <= kMostOrder;
  if (facts.extrapolated) facts.error_m = last / (std::exp2(*facts.order) - 1.0);
}

}  // namespace slipstitch
