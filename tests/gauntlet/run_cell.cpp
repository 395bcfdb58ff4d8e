// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "gauntlet/gauntlet_case.h"
#include "gauntlet/invariants.h"
#include "gauntlet/passages.h"
#include "model/check_values.h"
#include "sim/simulation.h"
#include "support/energy_budget.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kEnergyRoundOff = 1e-9;  // of the energy that was about

class Watch {
 public:
  Watch(const Limits& limits, CellResult& result) : limits_(limits), result_(result) {
    for (const Invariant& invariant : invariants()) result_.readings.push_back({invariant.name, 0.0, 0.0});
  }

  void start(Simulation& sim) {
    before_ = sim.state();
    passages_.emplace(sim.model());
    budget_.emplace(sim);
  }

  void after_step(Simulation& sim, const StepReport& report) {
    if (!report.accepted) return;
    const AcceptedStep step{sim, before_, sim.state(), report.newton};
    for (std::size_t i = 0; i < invariants().size(); ++i) {
      const double share = invariants()[i].share(step, limits_);
      Reading& reading = result_.readings[i];
      if (!(share <= reading.share)) reading = {reading.invariant, share, sim.state().t};
    }
    passages_->after_step(before_.q, sim.state().q);
    result_.passages = passages_->count();
    budget_->after_step();
    if (budget_->last_rise() > kEnergyRoundOff) ++result_.energy_rises;
    before_ = sim.state();
  }

  const test::EnergyBudget* budget() const { return budget_ ? &*budget_ : nullptr; }
  const State& last() const { return before_; }

 private:
  const Limits& limits_;
  CellResult& result_;
  State before_;
  std::optional<Passages> passages_;
  std::optional<test::EnergyBudget> budget_;
};

double largest_speed(const State& state, int nodes) {
  double largest = 0.0;
  for (int n = 0; n < nodes; ++n) largest = std::max(largest, state.v.segment<3>(3 * n).norm());
  return largest;
}

bool names_place_effect_and_time(const std::string& message) {
  const auto has = [&](const char* part) { return message.find(part) != std::string::npos; };
  return (has("course ") || has("of yarn") || has("bind-off")) && has(" t = ");
}

/// Shorter steps may be so many more, as far as they are run.
double effort_factor(const Settings& settings) {
  return settings.step_factor < 1.0 ? std::min(1.0 / settings.step_factor, kMostSteps) : 1.0;
}

/// Whether the run took more than the case gives it.
bool over_budget(const GauntletCase& item, const Settings& settings, const RunSummary& summary) {
  const auto over = [&](long used, long limit) {
    return static_cast<double>(used) > static_cast<double>(limit) * effort_factor(settings);
  };
  return over(summary.steps, item.limits.max_steps) || over(summary.newton_iterations, item.limits.max_newton);
}

/// Softer and stiffer yarn takes another time for it, and shorter steps are run less far.
bool comes_to_rest(const Settings& settings) {
  return !settings.quasi_static && settings.stiffness_factor == 1.0 && settings.step_factor >= 1.0;
}

/// What the run broke that no single step shows; empty: nothing.
std::string broken_at_the_end(const GauntletCase& item, const Settings& settings, const CellResult& result,
                              const test::EnergyBudget& budget) {
  struct Bound {
    bool asked;
    const char* what;
    double is, may;
  };
  const RunSummary& summary = result.summary;
  const Limits& limits = item.limits;
  const auto count = [](long n) { return static_cast<double>(n); };
  const Bound bounds[] = {
      {true, "ridge entries", count(summary.wrap_ridge_entries.value_or(0)), count(limits.max_ridge_entries)},
      {true, "fade entries", count(summary.wrap_fade_entries.value_or(0)), count(limits.max_fade_entries)},
      {item.scene.effects.self_collision.has_value(), "passages of yarn through yarn", count(result.passages), 0.0},
      {true, "crushed entries", count(summary.crushed_entries.value_or(0)), count(limits.max_crushed_entries)},
      {limits.isolated, "share of energy gained", budget.excess(), kEnergyRoundOff},
      {comes_to_rest(settings), "speed at the end", result.end_speed_m_per_s, limits.rest_speed_m_per_s},
  };
  for (const Bound& bound : bounds)
    if (bound.asked && !(bound.is <= bound.may))
      return std::string(bound.what) + ": " + number_text(bound.is) + ", at most " + number_text(bound.may);
  return {};
}

}  // namespace

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed:
      return "pass";
    case Outcome::cut:
      return "cut";
    case Outcome::refused:
      return "refused";
    case Outcome::failed:
      return "fail";
  }
  return "unknown";
}

Scene scene_of(const GauntletCase& item, const Settings& settings) {
  Scene scene = item.scene;
  scene.name = item.name;
  scene.yarn.stretch_n *= settings.stiffness_factor;
  scene.yarn.bending_nm2 *= settings.stiffness_factor;
  auto& numerics = std::get<FixedNumerics>(scene.numerics);
  numerics.integrator = settings.integrator;
  numerics.time_step_s *= settings.step_factor;
  scene.frames_per_s = std::min(scene.frames_per_s, 1.0 / numerics.time_step_s);
  if (settings.step_factor < 1.0) scene.duration_s = std::min(scene.duration_s, kMostSteps * numerics.time_step_s);
  if (std::isfinite(item.limits.rest_speed_m_per_s))
    scene.duration_s = std::max(scene.duration_s, kStepsToRest * numerics.time_step_s);
  if (settings.quasi_static && !item.about_motion) {
    scene.effects.inertia.reset();
    numerics.max_newton_iterations = 2000;  // no step is so short that its equilibrium is near
    // Weights and loads do not get less with the stiffness.
    numerics.force_tolerance_n *= std::max(1.0, settings.stiffness_factor);
  }
  return scene;
}

CellResult run_cell(const GauntletCase& item, const Settings& settings) {
  CellResult result;
  const Scene scene = scene_of(item, settings);
  if (const Issues issues = check(scene); !issues.empty()) {
    result.why = issues[0].path + " is " + issues[0].value + ", expected " + issues[0].expected;
    return result;
  }
  Watch watch(item.limits, result);
  long steps = 0;
  RunHooks hooks;
  hooks.on_model = [&](Model& model) {
    if (item.change) item.change(model);
    model.naive = settings.naive;
  };
  if (settings.simplicial) hooks.make_solver = [] { return make_cholmod_solver(Factorization::simplicial); };
  hooks.on_start = [&](Simulation& sim) { watch.start(sim); };
  hooks.on_step = [&](Simulation& sim, const StepReport& report) {
    watch.after_step(sim, report);
    steps += report.accepted;
  };
  const long budget = static_cast<long>(static_cast<double>(item.limits.max_steps) * effort_factor(settings));
  long asked = 0;  // about once a Newton iteration
  const double most = 2.0 * static_cast<double>(item.limits.max_newton) * effort_factor(settings);
  hooks.should_stop = [&] { return steps > budget || static_cast<double>(++asked) > most; };
  result.summary = run(scene, 1, hooks);
  result.end_speed_m_per_s = largest_speed(watch.last(), result.summary.nodes);
  for (const Reading& reading : result.readings)
    if (!(reading.share <= 1.0))
      result.why = reading.invariant + " broken, " + number_text(reading.share) +
                   " of what is allowed, at t = " + number_text(reading.t) + " s";
  if (!result.why.empty()) return result;
  const RunSummary& summary = result.summary;
  if (summary.status == RunStatus::failed) {
    result.why = summary.message;
    result.gave_up = true;
    if (item.limits.impossible && names_place_effect_and_time(summary.message)) result.outcome = Outcome::refused;
    return result;
  }
  if (summary.status == RunStatus::cancelled) {
    result.gave_up = true;
    result.why = "not at its end after " + std::to_string(summary.steps) + " steps and " +
                 std::to_string(summary.newton_iterations) +
                 " Newton iterations, at t = " + number_text(summary.sim_time_s) + " s";
    return result;
  }
  result.why = broken_at_the_end(item, settings, result, *watch.budget());
  if (result.why.empty() && over_budget(item, settings, summary)) {
    result.gave_up = true;
    result.why = "at its end only after " + std::to_string(summary.steps) + " steps and " +
                 std::to_string(summary.newton_iterations) + " Newton iterations";
  }
  if (result.why.empty()) result.outcome = summary.rejected_steps > 0 ? Outcome::cut : Outcome::passed;
  return result;
}

}  // namespace slipstitch::gauntlet
