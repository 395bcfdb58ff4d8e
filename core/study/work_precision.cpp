// SPDX-License-Identifier: MIT
#include "study/work_precision.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sim/describe_place.h"
#include "sim/prepare.h"
#include "study/accuracy_price.h"
#include "study/compare_rungs.h"
#include "study/median.h"
#include "study/reference_search.h"

namespace slipstitch {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr double kLadderShare = 1.0 / 3.0;  // of the budget; what is left is the reference's
constexpr int kTimes = 3;
constexpr double kNextRungCost = 2.0;   // of the one before of the same method
constexpr double kReferenceWork = 6.0;  // of its first run: itself, its twin, one refinement and its twin
constexpr double kResolved = 3.0;       // times the error of the reference
constexpr const char* kNoTime = "did not fit into the time";

RungErrors errors_over(std::size_t frames, const TraceDifference& d) {
  RungErrors errors{kNothing, kNothing, kNothing, d.stored_j, d.force_n, d.length_m};
  if (frames < 2) return errors;  // all begin alike
  errors.position_m = largest(d.max_m, frames);
  errors.most_m = largest(d.most_m, frames);
  errors.rms_m = root_mean(d.mean_m2, frames);
  return errors;
}

class Study {
 public:
  Study(const Scene& scene, const WorkPrecisionOptions& options)
      : scene_(scene),
        runs_(options),
        short_run_s_(options.short_run_s),
        until_s_(options.budget_s > 0.0 ? options.budget_s : kForever),
        ladder_until_s_(options.budget_s > 0.0 ? kLadderShare * options.budget_s : kForever) {
    study_.scene = scene.name;
    study_.radius_m = scene.yarn.radius_m;
    study_.duration_s = scene.duration_s;
    study_.threads = options.threads;
    study_.quick = options.quick;
  }

  WorkPrecision go() {
    if (planned_frames(scene_.duration_s, scene_.frames_per_s) < 2) {
      study_.failure = "it lasts no time, so nothing can be wrong in it";
      return std::move(study_);
    }
    plan();
    run_ladder();
    repeat_short_ones();
    if (!runs_.ended() && !nothing_ran()) refer();
    sort_by_method();
    set_orders(study_.rungs);
    mark_front(study_.rungs);
    compare_with_baseline(study_.rungs);
    study_.digits = digit_prices(study_.rungs);
    study_.digit_factor = mean_digit_factor(study_.rungs);
    study_.stopped = runs_.stopped();
    if (!runs_.failure().empty()) study_.failure = runs_.failure();
    return std::move(study_);
  }

 private:
  void plan() {
    double finest = 0.0;
    for (Rung& rung : ladder(scene_, study_.quick)) {
      const double work = study_run(scene_, rung).work;
      finest = std::max(finest, work);
      runs_.plan(work);
      study_.rungs.emplace_back().rung = std::move(rung);
    }
    runs_.plan(2.0 * kReferenceWork * finest);
  }

  /// What the rung will take, by the next coarser one of its method; 0 where that is not known.
  double expected_wall(const RungResult& result) const {
    double wall = 0.0;
    for (const RungResult& other : study_.rungs)
      if (&other < &result && other.rung.method == result.rung.method && other.no_result.empty())
        wall = kNextRungCost * other.wall_s;
    return wall;
  }

  void run_ladder() {
    for (RungResult& result : study_.rungs) {
      const StudyRun run = study_run(scene_, result.rung);
      const bool fits = runs_.fits(expected_wall(result), ladder_until_s_);
      const std::optional<KeptRun> kept = fits ? runs_.get(run, ladder_until_s_) : runs_.find(run);
      if (runs_.ended()) return;
      if (kept) {
        take(*kept, result);
      } else {
        result.no_result = kNoTime;
      }
    }
  }

  void sort_by_method() {
    std::vector<std::string> methods;
    for (const RungResult& r : study_.rungs)
      if (std::find(methods.begin(), methods.end(), r.rung.method) == methods.end()) methods.push_back(r.rung.method);
    const auto place = [&](const RungResult& r) { return std::find(methods.begin(), methods.end(), r.rung.method); };
    std::stable_sort(study_.rungs.begin(), study_.rungs.end(),
                     [&](const RungResult& a, const RungResult& b) { return place(a) < place(b); });
  }

  void take(const KeptRun& kept, RungResult& result) {
    const RunSummary& summary = kept.summary;
    if (summary.status != RunStatus::succeeded) {
      result.failed = true;
      result.no_result = summary.message;
    }
    result.times = static_cast<int>(kept.wall_s.size());
    result.wall_s = median(kept.wall_s);
    result.memory_bytes = kept.memory_bytes;
    result.steps = summary.steps;
    result.rejected_steps = summary.rejected_steps;
    result.newton_iterations = summary.newton_iterations;
    result.factorizations = summary.factorizations;
    result.cg_iterations = summary.cg_iterations;
    result.error_estimate_m = summary.error_estimate_m;
    study_.loops = summary.loops;
    study_.dofs = summary.dofs;
    study_.frames = summary.frames;
  }

  bool nothing_ran() {
    if (std::any_of(study_.rungs.begin(), study_.rungs.end(), [](const RungResult& r) { return r.no_result.empty(); }))
      return false;
    const auto failed = std::find_if(study_.rungs.begin(), study_.rungs.end(), [](const auto& r) { return r.failed; });
    study_.failure = failed != study_.rungs.end() ? failed->no_result : "no run of it fits into the time";
    study_.reference.failure = "no rung ran";
    return true;
  }

  /// In turn, so that a machine that gets slower or faster on the way moves all.
  void repeat_short_ones() {
    for (int times = 2; times <= kTimes; ++times)
      for (RungResult& result : study_.rungs) {
        if (!result.no_result.empty() || result.times >= times || result.wall_s >= short_run_s_) continue;
        const StudyRun run = study_run(scene_, result.rung);
        if (!runs_.fits(result.wall_s, ladder_until_s_)) continue;
        if (!runs_.again(run, ladder_until_s_)) continue;
        if (const std::optional<KeptRun> kept = runs_.find(run)) take(*kept, result);
      }
  }

  void refer() {
    FoundReference found = find_reference(scene_, study_.rungs, runs_, study_.quick, until_s_);
    if (!found.trace.t.empty()) compare_with(found);
    study_.reference = std::move(found.facts);
  }

  void compare_with(FoundReference& found) {
    const FrameTrace& trace = found.trace;
    const RungDifferences differences = compare_rungs(scene_, study_.rungs, runs_, trace);
    const Horizon horizon = common_horizon(differences, found.parting_m, least_error(scene_));
    const std::size_t frames = horizon.frames;
    if (frames < trace.size()) study_.horizon_s = trace.t[frames];
    set_reference_error(found, frames, smallest_error(differences, horizon).value_or(0.0));
    study_.stored_j = *std::max_element(trace.stored_j.begin(), trace.stored_j.end());
    study_.force_n = *std::max_element(trace.force_n.begin(), trace.force_n.end());
    study_.length_m = *std::max_element(trace.length_m.begin(), trace.length_m.end());
    std::map<int, int> rungs_by_node;  // that have their largest error there
    for (std::size_t i = 0; i < differences.size(); ++i) {
      if (!differences[i]) continue;
      const TraceDifference& d = *differences[i];
      RungResult& result = study_.rungs[i];
      result.errors = errors_over(frames, d);
      if (frames > 1) ++rungs_by_node[d.node[place_of_largest(d.max_m, frames)]];
      const bool predictable = horizon.own[i] >= frames;
      result.resolved = predictable && result.errors->position_m > kResolved * found.facts.error_m.value_or(0.0);
      if (horizon.own[i] < trace.size()) result.predictable_until_s = trace.t[horizon.own[i]];
    }
    name_worst_place(rungs_by_node);
  }

  void name_worst_place(const std::map<int, int>& rungs_by_node) {
    const auto most = std::max_element(rungs_by_node.begin(), rungs_by_node.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most == rungs_by_node.end()) return;
    const Prepared prepared = prepare(scene_);
    if (prepared.failure) return;
    study_.worst_place = describe_coordinate(prepared.model.topology, 3 * most->first);
    study_.at_worst_place = most->second;
  }

  const Scene& scene_;
  StudyRuns runs_;
  const double short_run_s_, until_s_, ladder_until_s_;
  WorkPrecision study_;
};

}  // namespace

WorkPrecision study_work_precision(const Scene& scene, const WorkPrecisionOptions& options) {
  return Study(scene, options).go();
}

}  // namespace slipstitch
