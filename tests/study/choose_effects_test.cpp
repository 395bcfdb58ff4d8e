// SPDX-License-Identifier: MIT
#include "study/choose_effects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/effect_list.h"
#include "sim/sim_scenes.h"

namespace slipstitch::testing {
namespace {

/// A straight yarn that falls freely for 0.1 s.
Scene falling_yarn() {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  scene.effects = {};
  scene.effects.automatic.emplace();
  scene.duration_s = 0.1;
  scene.frames_per_s = 50.0;
  scene.numerics = FixedNumerics{.time_step_s = 0.005};
  return scene;
}

const EffectVerdict* verdict_on(const EffectChoice& choice, const std::string& effect) {
  const auto found = std::find_if(choice.verdicts.begin(), choice.verdicts.end(),
                                  [&](const EffectVerdict& v) { return v.effect == effect; });
  return found == choice.verdicts.end() ? nullptr : &*found;
}

TEST(ChooseEffects, KeepsWhatMattersAndDropsWhatDoesNot) {
  const ChosenScene chosen = choose_effects(falling_yarn(), 1, {});
  const Effects& effects = chosen.scene.effects;
  EXPECT_FALSE(effects.automatic);
  EXPECT_TRUE(effects.gravity && effects.inertia && effects.stretch);
  EXPECT_TRUE(effects.bending && effects.bending_jamming) << "no bound shows that it never curls up";
  EXPECT_FALSE(effects.sliding || effects.wrapping || effects.air_drag || effects.damping);
  EXPECT_DOUBLE_EQ(chosen.choice.window_s, 0.05);  // ten steps
  EXPECT_DOUBLE_EQ(chosen.choice.tolerance_m, 1e-3);
  const EffectVerdict* gravity = verdict_on(chosen.choice, "gravity");
  ASSERT_TRUE(gravity && gravity->kept && gravity->difference_m);
  // Of the first frame at which it is above the tolerance; less what the air takes.
  EXPECT_NEAR(*gravity->difference_m, 0.5 * 9.81 * 0.0125 * 0.0175, 1e-4);
  ASSERT_TRUE(verdict_on(chosen.choice, "wrapping"));
  EXPECT_NE(verdict_on(chosen.choice, "wrapping")->why.find("only stitches wrap"), std::string::npos);
  for (const EffectVerdict& verdict : chosen.choice.verdicts)
    EXPECT_EQ(verdict.kept, find_effect(verdict.effect)->listed(effects)) << verdict.effect;
}

TEST(ChooseEffects, HoldsTheTolerance) {
  Scene scene = falling_yarn();
  scene.effects.automatic->tolerance_m = 1.0;
  EXPECT_FALSE(choose_effects(scene, 1, {}).scene.effects.gravity);  // a centimetre does not matter now
  scene.effects.automatic->tolerance_m = 1e-9;
  scene.effects.automatic->window_s = 0.1;
  const ChosenScene strict = choose_effects(scene, 1, {});
  EXPECT_TRUE(strict.scene.effects.air_drag);
  EXPECT_DOUBLE_EQ(strict.choice.window_s, 0.1);
}

TEST(ChooseEffects, HoldsTheToleranceThatTheSceneAsksFor) {
  Scene scene = falling_yarn();
  scene.numerics = AccuracyNumerics{1e-5};
  const EffectChoice choice = choose_effects(scene, 1, {}).choice;
  EXPECT_DOUBLE_EQ(choice.tolerance_m, 1e-5);
  EXPECT_DOUBLE_EQ(choice.window_s, 0.01);  // a tenth: its steps have no length to go by
}

TEST(ChooseEffects, DropsCollidersOnlyByABoundOverTheWholeRun) {
  Scene scene = falling_yarn();
  scene.effects.automatic->tolerance_m = 1.0;  // what the window shows is never the reason
  scene.effects.air_drag = AirDragEffect{0.0, 0.0};
  CollidersEffect& effect = scene.effects.colliders.emplace();
  effect.colliders = {Collider{Plane{Vec3(0.0, -10.0, 0.0), Vec3::UnitY()}, 0.3, {}}};
  scene.duration_s = 0.1;
  const ChosenScene far = choose_effects(scene, 1, {});
  EXPECT_FALSE(far.scene.effects.colliders);
  EXPECT_NE(verdict_on(far.choice, "colliders")->why.find("bound"), std::string::npos);
  scene.duration_s = 2.0;  // it would arrive after 1.4 s, long after the window
  const ChosenScene near = choose_effects(scene, 1, {});
  EXPECT_TRUE(near.scene.effects.colliders);
  EXPECT_TRUE(verdict_on(near.choice, "colliders")->kept);
}

TEST(ChooseEffects, KeepsWhatCanSwitchOnLater) {
  Scene scene = free_swatch(3, 3);
  scene.effects = {};
  scene.effects.automatic = AutoEffects{1.0, 0.01};
  scene.effects.plasticity.emplace();
  const ChosenScene chosen = choose_effects(scene, 1, {});
  const Effects& effects = chosen.scene.effects;
  EXPECT_TRUE(effects.self_collision && effects.bending_jamming && effects.plasticity && effects.parallel_contact);
  EXPECT_TRUE(effects.bending && effects.sliding) << "what they need, though a metre is allowed";
  EXPECT_NE(verdict_on(chosen.choice, "sliding")->why.find("parallel_contact needs it"), std::string::npos);
  EXPECT_FALSE(verdict_on(chosen.choice, "self_collision")->difference_m);
  scene.effects.plasticity->yield_angle_rad = kPi;
  EXPECT_FALSE(choose_effects(scene, 1, {}).scene.effects.plasticity);
}

TEST(ChooseEffects, KeepsWhatAListedEffectNeedsThatMayActLater) {
  Scene scene = falling_yarn();
  scene.effects.plasticity.emplace();
  const ChosenScene chosen = choose_effects(scene, 1, {});
  EXPECT_TRUE(chosen.scene.effects.plasticity && chosen.scene.effects.bending);
  EXPECT_NE(verdict_on(chosen.choice, "bending")->why.find("needs it and may act later"), std::string::npos);
}

TEST(ChooseEffects, NeverMakesASceneThatWouldBeRefused) {
  Scene scene = falling_yarn();
  scene.effects.automatic->tolerance_m = 10.0;
  Collider ball{Sphere{Vec3(0.1, 1.0, 0.0), 0.01}, 0.3, {}};
  ball.dynamic.emplace().mass_kg = 0.1;
  scene.effects.colliders.emplace().colliders = {ball};
  ASSERT_TRUE(check(scene).empty());  // inertia comes by itself
  const ChosenScene chosen = choose_effects(scene, 1, {});
  EXPECT_TRUE(chosen.scene.effects.inertia);
  EXPECT_TRUE(check(chosen.scene).empty());
}

TEST(ChooseEffects, TheRunReportsTheChoice) {
  const RunSummary summary = run_scene(falling_yarn(), 1, {});
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  ASSERT_TRUE(summary.effect_choice);
  EXPECT_EQ(summary.effects, (std::vector<std::string>{"inertia", "gravity", "stretch", "bending", "bending_jamming",
                                                       "self_collision"}));
  EXPECT_GT(summary.effect_choice->wall_s, 0.0);
  EXPECT_GT(summary.wall_by_phase_s.at("choosing_effects"), 0.0);
  Scene listed = hanging_yarn();
  listed.duration_s = 0.05;
  const RunSummary as_listed = run_scene(listed, 1, {});
  EXPECT_FALSE(as_listed.effect_choice);
  EXPECT_FALSE(as_listed.wall_by_phase_s.contains("choosing_effects"));
}

TEST(ChooseEffects, TellsWhatItTriesBeforeTheRun) {
  const Scene scene = falling_yarn();
  std::vector<std::string> tried;
  std::size_t told = 0;
  Progress last;
  RunHooks hooks;
  hooks.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.duration_s, scene.duration_s);
    EXPECT_GT(progress.num_frames, 1);
    EXPECT_GE(progress.wall_s, last.wall_s) << "it does not begin again";
    if (progress.doing.empty()) {
      EXPECT_GT(progress.t, 0.0);
    } else {
      EXPECT_EQ(progress.t, 0.0);
      ++told;
      if (tried.empty() || tried.back() != progress.doing) tried.push_back(progress.doing);
    }
    last = progress;
  };
  const RunSummary summary = run_scene(scene, 1, hooks);
  ASSERT_EQ(summary.status, RunStatus::succeeded);
  ASSERT_TRUE(summary.effect_choice);
  EXPECT_GE(last.before_s, summary.effect_choice->wall_s);
  EXPECT_GT(last.wall_s, last.before_s);
  EXPECT_GE(summary.wall_s, last.wall_s) << "of choice and simulation together";
  ASSERT_GE(tried.size(), 3U);
  EXPECT_GT(told, 3 * tried.size()) << "after every step of a trial too";
  EXPECT_EQ(tried[0].find("choosing the effects: the first "), 0U) << tried[0];
  EXPECT_NE(tried[0].find(" s with all"), std::string::npos) << tried[0];
  EXPECT_NE(tried[1].find(" s without inertia"), std::string::npos) << tried[1];
}

TEST(ChooseEffects, CountsAsPartOfABudget) {
  Scene scene = falling_yarn();
  scene.numerics = BudgetNumerics{1000.0};
  double now = 0.0;
  RunHooks hooks;
  hooks.clock = [&] { return now; };
  hooks.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.budget_s, 1000.0);
    if (progress.doing.starts_with("choosing")) now = 900.0;
    now += 1.0;
  };
  const RunSummary summary = run_scene(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  ASSERT_TRUE(summary.budget && summary.effect_choice);
  EXPECT_GT(summary.wall_s, 900.0);
  EXPECT_EQ(summary.wall_s, now);
  EXPECT_EQ(summary.effect_choice->verdicts.empty(), false);
}

TEST(ChooseEffects, CanBeCancelled) {
  RunHooks hooks;
  double wall_s = 0.0;
  hooks.on_progress = [&](const Progress& progress) { wall_s = progress.wall_s; };
  hooks.should_stop = [&] { return wall_s > 0.0; };
  const RunSummary summary = run_scene(falling_yarn(), 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::cancelled);
  EXPECT_GT(wall_s, 0.0);
  EXPECT_GE(summary.wall_s, wall_s);
  EXPECT_EQ(summary.nodes, 0);
}

}  // namespace
}  // namespace slipstitch::testing
