// SPDX-License-Identifier: MIT
#include "study/effect_study.h"

#include <algorithm>
#include <cmath>

#include "model/effect_list.h"
#include "model/remarks.h"
#include "study/measured_run.h"
#include "study/median.h"

namespace slipstitch {
namespace {

struct Variant {
  Scene scene;
  EffectPrice price;
  std::vector<double> wall_s, ratio;  // of the variant; variant / scene (a value a round)
};

std::string why_not_added(const Scene& scene, const EffectEntry& effect, const Scene& with) {
  if (effect.needs_parameters) return "says nothing without parameters of the scene";
  const EffectEntry* needed = find_effect(effect.needs);
  if (needed != nullptr && !needed->listed(scene.effects)) return std::string("needs ") + effect.needs;
  for (const IdleEffect& idle : idle_effects(with))
    if (idle.effect == effect.name) return "cannot matter: " + idle.why;
  return {};
}

Variant make_variant(const Scene& scene, const EffectEntry& effect) {
  Variant variant{scene, {}, {}, {}};
  variant.price.effect = effect.name;
  variant.price.listed = effect.listed(scene.effects);
  if (variant.price.listed) {
    variant.price.together = remove_effect(variant.scene.effects, effect);
  } else {
    effect.add(variant.scene.effects);
    variant.price.not_compared = why_not_added(scene, effect, variant.scene);
  }
  const Issues issues = check(variant.scene);
  if (variant.price.not_compared.empty() && !issues.empty())
    variant.price.not_compared = issues[0].path + " needs it: the scene is refused without";
  return variant;
}

EffectSide side_of(const MeasuredRun& run) {
  EffectSide side;
  side.memory_bytes = run.memory_bytes;
  side.dofs = run.summary.dofs;
  side.nonzeros = run.summary.nonzeros;
  side.steps = run.summary.steps;
  side.newton_iterations = run.summary.newton_iterations;
  side.factorizations = run.summary.factorizations;
  side.cg_iterations = run.summary.cg_iterations;
  side.stored_j = run.stored_j;
  side.tension_n = run.tension_n;
  side.reaction_n = run.reaction_n;
  return side;
}

class Study {
 public:
  Study(const Scene& scene, const StudyOptions& options) : scene_(scene), options_(options) {
    for (const EffectEntry& effect : effect_list()) variants_.push_back(make_variant(scene, effect));
    const auto compared = std::count_if(variants_.begin(), variants_.end(),
                                        [](const Variant& v) { return v.price.not_compared.empty(); });
    runs_planned_ = options.rounds * (static_cast<int>(compared) + (static_cast<int>(compared) + 1) / 2);
  }

  EffectStudy go() {
    study_.scene = scene_.name;
    study_.radius_m = scene_.yarn.radius_m;
    study_.duration_s = scene_.duration_s;
    for (int round = 0; round < options_.rounds && study_.failure.empty(); ++round) {
      if (!run_round(round)) {
        study_.stopped = true;
        break;
      }
      study_.rounds = round + 1;
    }
    study_.repeatable = repeatable_;
    study_.itself.wall_s = median(own_wall_s_);
    for (Variant& variant : variants_) study_.prices.push_back(priced(std::move(variant)));
    return std::move(study_);
  }

 private:
  bool stop() const { return options_.should_stop && options_.should_stop(); }

  MeasuredRun measure(const Scene& scene, MeasureOptions options, const std::string& what) {
    options.threads = options_.threads;
    options.should_stop = options_.should_stop;
    options.on_progress = [&](double share) {
      if (options_.on_progress) options_.on_progress((runs_done_ + share) / runs_planned_, what);
    };
    MeasuredRun run = measure_run(scene, options);
    ++runs_done_;
    return run;
  }

  // Every other round goes backwards, so that no variant always follows the same one.
  bool run_round(int round) {
    std::vector<Variant*> order;
    for (Variant& variant : variants_)
      if (variant.price.not_compared.empty()) order.push_back(&variant);
    if (round % 2 == 1) std::reverse(order.begin(), order.end());
    double own_wall = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % 2 == 0 && !run_itself(own_wall)) return false;
      if (!study_.failure.empty()) return true;
      if (!run_variant(*order[i], own_wall)) return false;
    }
    return true;
  }

  bool run_itself(double& wall_s) {
    const bool first = own_wall_s_.empty();
    MeasureOptions options;
    if (first) options.record = &frames_;
    const MeasuredRun run = measure(scene_, options, "as it is");
    if (run.summary.status == RunStatus::cancelled || stop()) return false;
    if (run.summary.status == RunStatus::failed) study_.failure = run.summary.message;
    wall_s = run.summary.wall_s;
    own_wall_s_.push_back(wall_s);
    if (!first) {
      study_.itself.memory_bytes = std::min(study_.itself.memory_bytes, run.memory_bytes);
      repeatable_ = repeatable_ && run.summary.state_hash == state_hash_;
      return true;
    }
    state_hash_ = run.summary.state_hash;
    max_effort_ = options_.effort_factor * run.effort + options_.least_effort;
    study_.itself = side_of(run);
    study_.loops = run.summary.loops;
    study_.frames = run.summary.frames;
    return true;
  }

  bool run_variant(Variant& variant, double own_wall) {
    EffectPrice& price = variant.price;
    MeasureOptions options;
    options.reference = &frames_;
    options.max_effort = max_effort_;
    const MeasuredRun run = measure(variant.scene, options, (price.listed ? "without " : "with ") + price.effect);
    if (stop()) return false;
    if (run.summary.status != RunStatus::succeeded) {
      price.not_compared = run.summary.status == RunStatus::failed
                               ? run.summary.message
                               : "given up at t = " + std::to_string(run.summary.sim_time_s) + " s, after " +
                                     std::to_string(run.effort) + " iterations";
      price.not_compared = (price.listed ? "without it: " : "with it: ") + price.not_compared;
      return true;
    }
    variant.wall_s.push_back(run.summary.wall_s);
    variant.ratio.push_back(run.summary.wall_s / own_wall);
    price.max_displacement_m = run.difference.max_m;
    price.rms_displacement_m = run.difference.rms_m;
    EffectSide& side = price.listed ? price.without : price.with;
    const double memory = side.steps > 0 ? std::min(side.memory_bytes, run.memory_bytes) : run.memory_bytes;
    side = side_of(run);
    side.memory_bytes = memory;
    return true;
  }

  EffectPrice priced(Variant variant) const {
    EffectPrice& price = variant.price;
    const double ratio = median(variant.ratio);
    (price.listed ? price.without : price.with).wall_s = median(variant.wall_s);
    (price.listed ? price.with : price.without) = study_.itself;
    price.time_ratio = price.listed && ratio > 0.0 ? 1.0 / ratio : ratio;
    return std::move(price);
  }

  const Scene& scene_;
  const StudyOptions& options_;
  EffectStudy study_;
  std::vector<Variant> variants_;
  RecordedFrames frames_;
  std::vector<double> own_wall_s_;
  std::string state_hash_;
  bool repeatable_ = true;
  long max_effort_ = 0;
  int runs_planned_ = 0, runs_done_ = 0;
};

}  // namespace

EffectStudy study_effects(const Scene& scene, const StudyOptions& options) { return Study(scene, options).go(); }

}  // namespace slipstitch
