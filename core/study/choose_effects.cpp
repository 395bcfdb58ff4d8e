// SPDX-License-Identifier: MIT
#include "study/choose_effects.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "model/effect_list.h"
#include "model/remarks.h"
#include "sim/prepare.h"
#include "study/measured_run.h"
#include "study/reach.h"
#include "study/three_digits.h"

namespace slipstitch {
namespace {

/// What a run of the window can tell about, dearest first.
constexpr std::array kTried{"sliding",          "wrapping", "bending",  "inertia", "contact_length",
                            "sliding_friction", "damping",  "air_drag", "wind",    "gravity"};

/// Newton iterations that a trial may always take; beyond, and beyond what it could save, it is given up.
constexpr double kLeastEffort = 100.0;

constexpr const char* kChoosing = "choosing_effects";  // phase of a run's wall time

}  // namespace

Scene with_candidates(const Scene& scene) {
  Scene listed = scene;
  if (!scene.effects.automatic) return listed;
  listed.effects.automatic.reset();
  for (const EffectEntry& effect : effect_list())
    if (!effect.needs_parameters && !effect.listed(listed.effects) && std::string_view(effect.name) != "plasticity")
      effect.add(listed.effects);
  return listed;
}

namespace {

class Chooser {
 public:
  using OnTrial = std::function<void(const std::string& what)>;

  Chooser(const Scene& scene, int threads, const std::function<bool()>& should_stop, const OnTrial& on_trial)
      : threads_(threads), should_stop_(should_stop), on_trial_(on_trial), chosen_{with_candidates(scene), {}, false} {
    EffectChoice& choice = chosen_.choice;
    const AutoEffects& asked = *scene.effects.automatic;
    const auto* fixed = std::get_if<FixedNumerics>(&scene.numerics);
    const auto* accurate = std::get_if<AccuracyNumerics>(&scene.numerics);
    choice.tolerance_m = asked.tolerance_m.value_or(accurate ? accurate->tolerance_m : scene.yarn.radius_m);
    const double usual = std::max(scene.duration_s / 10.0, fixed ? 10.0 * fixed->time_step_s : 0.0);
    choice.window_s = std::min(asked.window_s.value_or(usual), scene.duration_s);
  }

  ChosenScene go() {
    const auto start = std::chrono::steady_clock::now();
    drop_idle();
    drop_what_cannot_act();
    verdict("stretch", true, "yarn has no length without it");
    try_the_others();
    auto& verdicts = chosen_.choice.verdicts;
    std::stable_sort(verdicts.begin(), verdicts.end(), [](const EffectVerdict& a, const EffectVerdict& b) {
      return find_effect(a.effect) < find_effect(b.effect);
    });
    chosen_.choice.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return std::move(chosen_);
  }

 private:
  Effects& effects() { return chosen_.scene.effects; }

  void verdict(const std::string& effect, bool kept, const std::string& why, std::optional<double> difference = {}) {
    chosen_.choice.verdicts.push_back({effect, kept, why, difference});
  }

  void drop(const EffectEntry& effect, const std::string& why, std::optional<double> difference = {}) {
    verdict(effect.name, false, why, difference);
    for (const std::string& other : remove_effect(effects(), effect)) {
      auto& verdicts = chosen_.choice.verdicts;
      std::erase_if(verdicts, [&](const EffectVerdict& v) { return v.effect == other; });
      verdict(other, false, std::string("cannot act without ") + effect.name + ", which is left out");
    }
  }

  void drop_idle() {
    for (const IdleEffect& idle : idle_effects(chosen_.scene))
      if (const EffectEntry* effect = find_effect(idle.effect); effect->listed(effects()))
        drop(*effect, "cannot matter: " + idle.why);
  }

  void keep(const char* effect, const std::string& why) {
    if (find_effect(effect)->listed(effects())) verdict(effect, true, why);
  }

  void drop_what_cannot_act() {
    Prepared prepared = prepare(chosen_.scene, should_stop_);
    if (prepared.failure || prepared.cancelled) return;  // the run will say so
    Simulation sim(std::move(prepared.model));
    const EffectCosts costs = sim.effect_costs();
    drop_or_keep_colliders(sim);
    keep("self_collision", "no bound shows that parts of the fabric never meet");
    for (const char* late : {"parallel_contact", "bending_jamming"}) {
      const EffectEntry& effect = *find_effect(late);
      if (!effect.listed(effects())) continue;
      if (!costs.contains(late)) {
        drop(effect, "cannot act: there is no place in the yarn for it");
      } else {
        verdict(late, true, "no bound shows that it never switches on");
      }
    }
    keep("plasticity", "no bound shows that no bend ever yields");
    keep("shrinkage", "its script may act after the window");
  }

  void drop_or_keep_colliders(Simulation& sim) {
    if (!effects().colliders) return;
    auto& colliders = effects().colliders->colliders;
    const RunSpan span = span_of(chosen_.scene);
    std::vector<int> out = colliders_out_of_reach(sim, bound_reach(sim, span), span);
    // Where a dynamic sphere goes is part of the result.
    std::erase_if(out, [&](int i) { return colliders[static_cast<std::size_t>(i)].dynamic.has_value(); });
    for (auto i = out.rbegin(); i != out.rend(); ++i) colliders.erase(colliders.begin() + *i);
    const std::string found =
        out.empty() ? "" : std::to_string(out.size()) + " can never be reached and are left out; ";
    if (colliders.empty()) {
      drop(*find_effect("colliders"), "cannot act: a bound shows that none is ever reached");
    } else {
      verdict("colliders", true, found + "no bound shows that the fabric never comes near");
    }
  }

  /// The scene with these effects, as far as the window.
  Scene window_of(const Effects& with) const {
    Scene scene = chosen_.scene;
    scene.effects = with;
    scene.duration_s = chosen_.choice.window_s;
    scene.frames_per_s = std::max(scene.frames_per_s, 4.0 / chosen_.choice.window_s);
    return scene;
  }

  static double cost_of(const MeasuredRun& run) {
    return static_cast<double>(run.effort) * static_cast<double>(run.summary.nonzeros);
  }

  void try_the_others() {
    RecordedFrames frames;
    MeasureOptions options;
    options.threads = threads_;
    options.should_stop = should_stop_;
    options.record = &frames;
    options.on_progress = [this](double) {
      if (on_trial_) on_trial_(telling_);
    };
    tell("with all that may matter");
    const MeasuredRun all = measure_run(window_of(effects()), options);
    chosen_.cancelled = all.summary.status == RunStatus::cancelled;
    options.record = nullptr;
    options.reference = &frames;
    options.max_difference_m = chosen_.choice.tolerance_m;
    double cost = cost_of(all);
    for (const char* name : kTried) {
      const EffectEntry& effect = *find_effect(name);
      if (chosen_.cancelled || !effect.listed(effects())) continue;
      if (all.summary.status == RunStatus::failed) {
        verdict(name, true, "the window does not run: " + all.summary.message);
        continue;
      }
      if (const std::string why = needed_for(effect); !why.empty()) {
        verdict(name, true, why);
        continue;
      }
      Effects without = effects();
      remove_effect(without, effect);
      tell(std::string("without ") + name);
      options.max_cost = 1.25 * cost + kLeastEffort * static_cast<double>(all.summary.nonzeros);
      const MeasuredRun run = measure_run(window_of(without), options);
      judge(effect, run, cost);
    }
  }

  void tell(const std::string& what) {
    telling_ = "choosing the effects: the first " + three_digits(chosen_.choice.window_s) + " s " + what;
    if (on_trial_) on_trial_(telling_);
  }

  void judge(const EffectEntry& effect, const MeasuredRun& run, double& cost) {
    if (should_stop_ && should_stop_()) {
      chosen_.cancelled = true;
    } else if (run.difference.max_m > chosen_.choice.tolerance_m) {  // tried no farther
      verdict(effect.name, true, "it matters in the window", run.difference.max_m);
    } else if (run.summary.status != RunStatus::succeeded) {
      verdict(effect.name, true,
              run.summary.status == RunStatus::failed ? "the window does not run without it"
                                                      : "it saves more than it costs: the window is dearer without it");
    } else if (cost_of(run) > cost) {
      verdict(effect.name, true, "it does not matter in the window, but saves more than it costs",
              run.difference.max_m);
    } else {
      cost = cost_of(run);
      drop(effect, "it does not matter in the window", run.difference.max_m);
    }
  }

  /// Why an effect must stay whatever the window shows: for one that may act later, or because the scene would be
  /// refused; empty: it need not.
  std::string needed_for(const EffectEntry& effect) const {
    Effects without = chosen_.scene.effects;
    for (const std::string& other : remove_effect(without, effect))
      for (const char* late : {"bending_jamming", "parallel_contact", "plasticity", "shrinkage"})
        if (other == late) return other + " needs it and may act later";
    Scene scene = chosen_.scene;
    scene.effects = without;
    const Issues issues = check(scene);
    return issues.empty() ? "" : issues[0].path + " needs it";
  }

  int threads_;
  const std::function<bool()>& should_stop_;
  const OnTrial& on_trial_;
  std::string telling_;
  ChosenScene chosen_;
};

}  // namespace

ChosenScene choose_effects(const Scene& scene, int threads, const std::function<bool()>& should_stop,
                           const std::function<void(const std::string& what)>& on_trial) {
  return Chooser(scene, threads, should_stop, on_trial).go();
}

RunSummary run_scene(const Scene& scene, int threads, const RunHooks& hooks) {
  if (!scene.effects.automatic) return run(scene, threads, hooks);
  const Clock clock = hooks.clock ? hooks.clock : steady_clock_s;
  const double start = hooks.began_s ? *hooks.began_s : clock();
  const auto wall = [&] { return clock() - start; };
  ChosenScene chosen = choose_effects(scene, threads, hooks.should_stop, [&](const std::string& what) {
    Progress progress;
    progress.duration_s = scene.duration_s;
    progress.num_frames = planned_frames(scene.duration_s, scene.frames_per_s);
    progress.wall_s = progress.before_s = wall();
    if (const auto* numerics = std::get_if<BudgetNumerics>(&scene.numerics)) progress.budget_s = numerics->budget_s;
    progress.wall_by_phase_s[kChoosing] = progress.wall_s;
    progress.doing = what;
    if (hooks.on_progress) hooks.on_progress(progress);
  });
  RunSummary summary;
  if (chosen.cancelled) {
    summary.scene = scene.name;
    summary.status = RunStatus::cancelled;
    summary.threads = threads;
    summary.wall_s = summary.wall_by_phase_s[kChoosing] = wall();
    return summary;
  }
  const double before_s = wall();
  RunHooks later = hooks;
  later.began_s = start;
  if (hooks.on_progress) {
    later.on_progress = [&](Progress progress) {
      progress.before_s = std::max(progress.before_s, before_s);
      progress.wall_by_phase_s[kChoosing] = before_s;
      hooks.on_progress(progress);
    };
  }
  summary = run(chosen.scene, threads, later);
  summary.wall_by_phase_s[kChoosing] = before_s;
  summary.effect_choice = std::move(chosen.choice);
  return summary;
}

}  // namespace slipstitch
