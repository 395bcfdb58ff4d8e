// SPDX-License-Identifier: MIT
#include "study/prediction.h"

#include <algorithm>
#include <cmath>

#include "model/effect_list.h"
#include "sim/pair_goal.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/simulation.h"
#include "study/choose_effects.h"
#include "study/heap.h"

namespace slipstitch {
namespace {

constexpr double kTolerances_m[] = {1e-3, 1e-4, 1e-5};
constexpr double kShareAsItIs = 0.4;   // of the budget, where there is a pilot to a tolerance too
constexpr double kShareOfRun = 0.1;    // of the run, that its pilot may take
constexpr double kLeastPilot_s = 0.2;  // that may be taken however short the run
constexpr double kFewest = 8.0;        // iterations without which a pilot says nothing
constexpr double kModelled = 4.0;      // iterations by the model that count as one that was timed, four times over
constexpr double kMatrixBytes = 12.0;  // of an entry of the Hessian: value and row
constexpr double kFactorBytes = 8.0;

/// A run as it was begun, and where it will end.
struct Begun {
  Pilot pilot;
  double tolerance_m = 0.0;  // 0: fixed numerics
  RunPrediction run;
};

class Predictor {
 public:
  Predictor(const Scene& given, const PredictOptions& options)
      : options_(options), scene_(with_candidates(given)), known_(*options.calibration) {}

  Prediction go() {
    if (!count()) return result_;
    const auto* accuracy = std::get_if<AccuracyNumerics>(&scene_.numerics);
    const auto* budget = std::get_if<BudgetNumerics>(&scene_.numerics);
    const double own = accuracy != nullptr ? accuracy->tolerance_m : 0.0;
    if (fixed()) predict_fixed();
    if (scene_.effects.inertia) {
      predict_tolerances(std::max(own, kPilotTolerance_m), own);
    } else if (accuracy != nullptr) {
      predict_static(scene_);
    }
    if (budget != nullptr) predict_budget(budget->budget_s);
    set_memory(!fixed());
    return result_;
  }

 private:
  double each_s() const { return iteration_s(known_.cost, size_); }
  bool worth_a_pilot(double budget_s) const { return budget_s >= kFewest * each_s() && budget_s > 0.0; }
  bool scene_has(double tolerance_m) const {
    const auto* accuracy = std::get_if<AccuracyNumerics>(&scene_.numerics);
    return accuracy != nullptr && accuracy->tolerance_m == tolerance_m;
  }
  bool fixed() const { return std::holds_alternative<FixedNumerics>(scene_.numerics); }

  bool count() {
    result_.effects = effect_names(scene_.effects);
    result_.frames = planned_frames(scene_.duration_s, scene_.frames_per_s);
    if (const auto* numerics = std::get_if<FixedNumerics>(&scene_.numerics))
      result_.least_steps = least_steps(scene_.duration_s, scene_.frames_per_s, numerics->time_step_s);
    Scene drawn = scene_;
    if (drawn.knit) drawn.knit->relax_repeat = false;
    const double start = options_.clock();
    const double heap = heap_in_use();
    Prepared prepared = prepare(drawn);
    if (prepared.failure) {
      result_.failure = *prepared.failure;
      return false;
    }
    const Simulation simulation(std::move(prepared.model));
    model_bytes_ = std::max(0.0, heap_in_use() - heap);
    setup_s_ = options_.clock() - start;
    result_.loops = static_cast<int>(simulation.model().topology.stitches.size());
    result_.nodes = simulation.model().topology.num_nodes;
    result_.dofs = size_.dofs = simulation.num_dofs();
    result_.hessian_nonzeros = simulation.num_nonzeros();
    size_.nonzeros = static_cast<double>(result_.hessian_nonzeros);
    size_.factor = scaled_factor(known_.sheet, size_.dofs);
    return true;
  }

  /// `own`: the scene as it is.
  Pilot pilot(const Scene& scene, double budget_s, bool own) {
    Pilot begun = run_pilot(scene, {budget_s, known_.cost}, options_.clock);
    if (begun.size.factor.entries > 0.0) size_.factor = begun.size.factor;
    if (own) result_.run_fails = begun.failure;
    return begun;
  }

  /// Timed iterations say more than the model, the more of them there are.
  RunPrediction run_of(const RunPoint& end, const Pilot& begun) const {
    const double timed = begun.course.empty() ? 0.0 : begun.course.back().iterations;
    const double each = (begun.wall_s + kModelled * each_s()) / (timed + kModelled);
    return {end.steps, end.iterations, std::max(setup_s_, begun.setup_s) + end.iterations * each};
  }

  static PilotBasis basis_of(const Pilot& begun, double tolerance_m) {
    const double until = begun.course.empty() ? 0.0 : begun.course.back().t;
    const Basis basis = begun.finished ? Basis::whole_run : until > 0.0 ? Basis::first_moments : Basis::canned_run;
    return {basis, until, tolerance_m};
  }

  void predict_fixed() {
    if (!scene_.effects.inertia) return predict_static(scene_);
    // The canned run's steps are those of the default numerics.
    const RunPoint canned = counts_at(known_.fixed, scene_.duration_s);
    const auto steps = static_cast<double>(*result_.least_steps);
    const double iterations = steps * canned.iterations / std::max(canned.steps, 1.0);
    const double share = kShareAsItIs * options_.budget_s;
    const double budget = std::min(share, std::max(kLeastPilot_s, kShareOfRun * iterations * each_s()));
    Pilot begun;  // not made unless it is worth it
    if (worth_a_pilot(budget)) begun = pilot(scene_, budget, true);
    RunPoint end{scene_.duration_s, steps, iterations};
    if (!begun.course.empty()) end = extrapolate(begun.course, scene_.duration_s, known_.fixed);
    end.steps = std::max(end.steps, steps);
    result_.as_it_is = run_of(end, begun);
    result_.as_it_is_basis = basis_of(begun, 0.0);
  }

  /// One solve or a few, of as many iterations as they take: known where it is soon over.
  void predict_static(const Scene& scene) {
    if (!worth_a_pilot(options_.budget_s)) return;
    const Pilot begun = pilot(scene, options_.budget_s, true);
    if (!begun.finished) return;
    const RunPoint end = begun.course.empty() ? RunPoint{} : begun.course.back();
    result_.as_it_is = run_of(end, begun);
    result_.as_it_is_basis = basis_of(begun, 0.0);
  }

  /// To the coarsest tolerance, and to finer ones while there is time.
  void predict_tolerances(double coarsest_m, double own_m) {
    double left = (fixed() ? 1.0 - kShareAsItIs : 1.0) * options_.budget_s;
    std::vector<Begun> known{begin(coarsest_m, left, nullptr)};
    result_.to_tolerance_basis = basis_of(known[0].pilot, coarsest_m);
    for (double finer = 0.1 * coarsest_m; finer >= 0.99 * finest(own_m); finer *= 0.1) {
      const Pilot& last = known.back().pilot;
      left -= last.setup_s + last.wall_s;
      if (!last.finished || !worth_a_pilot(left)) break;
      known.push_back(begin(finer, left, &known.back()));
      if (known.back().pilot.finished) result_.to_tolerance_basis = basis_of(known.back().pilot, finer);
    }
    for (const double tolerance : kTolerances_m)
      result_.to_tolerance.push_back({tolerance, scaled(nearest(known, tolerance), tolerance)});
    if (std::holds_alternative<BudgetNumerics>(scene_.numerics)) known_runs_ = known;
    if (own_m == 0.0) return;
    const Begun& own = nearest(known, own_m);
    result_.as_it_is = scaled(own, own_m);
    result_.as_it_is_basis = basis_of(own.pilot, own.tolerance_m);
  }

  /// It takes what it is given, but for what it cannot do with less. Of static scenes no more is known.
  void predict_budget(double budget_s) {
    if (known_runs_.empty()) {
      result_.as_it_is = RunPrediction{0.0, 0.0, budget_s};
      return;
    }
    double fine = AccuracyNumerics::kLeastTolerance_m, coarse = loosest_tolerance_m(scene_.yarn.radius_m);
    const auto run_to = [&](double tolerance) { return scaled(nearest(known_runs_, tolerance), tolerance); };
    for (int i = 0; i < 30; ++i) {
      const double middle = std::sqrt(fine * coarse);
      (run_to(middle).wall_s <= budget_s ? coarse : fine) = middle;
    }
    const Begun& begun = nearest(known_runs_, coarse);
    result_.as_it_is = run_to(coarse);
    result_.as_it_is_basis = basis_of(begun.pilot, begun.tolerance_m);
    result_.budget_tolerance_m = coarse;
  }

  /// The finest that is not finer; they are from coarse to fine, and the first is coarse enough for all.
  static const Begun& nearest(const std::vector<Begun>& known, double tolerance_m) {
    std::size_t found = 0;
    for (std::size_t i = 1; i < known.size(); ++i)
      if (known[i].tolerance_m >= 0.99 * tolerance_m) found = i;
    return known[found];
  }

  static double finest(double own_m) {
    return own_m > 0.0 ? std::min(own_m, *std::rbegin(kTolerances_m)) : *std::rbegin(kTolerances_m);
  }

  Begun begin(double tolerance_m, double budget_s, const Begun* coarser) {
    Begun begun;
    begun.tolerance_m = tolerance_m;
    Scene scene = scene_;
    scene.numerics = AccuracyNumerics{tolerance_m};
    if (worth_a_pilot(budget_s)) begun.pilot = pilot(scene, budget_s, scene_has(tolerance_m));
    const RunCourse& course = begun.pilot.course;
    RunPoint end;
    if (coarser != nullptr) {
      const RunPoint known{scene_.duration_s, coarser->run.steps, coarser->run.iterations};
      end = extrapolate(course, scene_.duration_s, at_tolerance(known, coarser->tolerance_m, tolerance_m));
    } else {
      end = extrapolate(course, scene_.duration_s, known_.accurate);
    }
    begun.run = run_of(end, begun.pilot);
    return begun;
  }

  RunPrediction scaled(const Begun& begun, double tolerance_m) const {
    const RunPoint known{scene_.duration_s, begun.run.steps, begun.run.iterations};
    RunPoint end = at_tolerance(known, begun.tolerance_m, tolerance_m);
    const double least = 2.0 * (result_.frames - 1);  // steps come in pairs
    if (end.steps > 0.0 && end.steps < least) end = {end.t, least, end.iterations * least / end.steps};
    return run_of(end, begun.pilot);
  }

  /// A companion has a model, a matrix and a factor of its own.
  void set_memory(bool accurate) {
    const double each = model_bytes_ + 2.0 * kMatrixBytes * size_.nonzeros + kFactorBytes * size_.factor.entries;
    result_.memory_bytes = options_.program_bytes + (accurate ? 2.0 : 1.0) * each;
  }

  const PredictOptions& options_;
  const Scene scene_;
  const Calibration& known_;
  ProblemSize size_;
  double setup_s_ = 0.0, model_bytes_ = 0.0;
  std::vector<Begun> known_runs_;  // of a scene with a budget
  Prediction result_;
};

}  // namespace

Prediction predict(const Scene& scene, const PredictOptions& options) { return Predictor(scene, options).go(); }

}  // namespace slipstitch
