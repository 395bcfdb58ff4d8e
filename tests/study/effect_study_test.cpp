// SPDX-License-Identifier: MIT
#include "study/effect_study.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/effect_list.h"
#include "sim/sim_scenes.h"
#include "study/measured_run.h"

namespace slipstitch::testing {
namespace {

/// A straight yarn that falls freely: without gravity it stays where it is.
Scene falling_yarn() {
  Scene scene = hanging_yarn();
  scene.name = "fall";
  scene.handles.clear();
  scene.duration_s = 0.1;
  scene.frames_per_s = 40.0;
  scene.numerics = FixedNumerics{.time_step_s = 0.005};
  return scene;
}

StudyOptions rounds(int count) {
  StudyOptions options;
  options.rounds = count;
  return options;
}

const EffectPrice& price_of(const EffectStudy& study, const std::string& effect) {
  return *std::find_if(study.prices.begin(), study.prices.end(),
                       [&](const EffectPrice& p) { return p.effect == effect; });
}

TEST(EffectStudy, RunsScenesWithABudgetToATolerance) {
  Scene scene = falling_yarn();
  scene.numerics = BudgetNumerics{1e-9};
  const MeasuredRun within = measure_run(scene, {});
  EXPECT_FALSE(within.summary.budget);
  scene.numerics = AccuracyNumerics{0.1 * scene.yarn.radius_m};
  EXPECT_EQ(within.summary.state_hash, measure_run(scene, {}).summary.state_hash);
}

TEST(EffectStudy, MeasuresWhatAnEffectMoves) {
  const EffectStudy study = study_effects(falling_yarn(), rounds(2));
  ASSERT_EQ(study.failure, "");
  EXPECT_EQ(study.rounds, 2);
  EXPECT_TRUE(study.repeatable);
  const EffectPrice& gravity = price_of(study, "gravity");
  EXPECT_TRUE(gravity.listed);
  EXPECT_EQ(gravity.not_compared, "");
  // Implicit Euler falls g t (t + h) / 2. Five frames: at 0, 0.025, ..., 0.1 s.
  const auto fall = [](double t) { return 0.5 * 9.81 * t * (t + 0.005); };
  EXPECT_NEAR(gravity.max_displacement_m, fall(0.1), 1e-9);
  double squares = 0.0;
  for (int frame = 0; frame < 5; ++frame) squares += std::pow(fall(0.025 * frame), 2);
  EXPECT_NEAR(gravity.rms_displacement_m, std::sqrt(squares / 5.0), 1e-9);
  const EffectPrice& bending = price_of(study, "bending");  // the yarn is straight
  EXPECT_NEAR(bending.max_displacement_m, 0.0, 1e-9);
  EXPECT_GT(bending.with.nonzeros, bending.without.nonzeros);
  EXPECT_GT(bending.time_ratio, 0.0);
}

TEST(EffectStudy, ComparesListedEffectsWithoutAndOthersWithThem) {
  Scene scene = crossed_yarns();
  scene.duration_s = 0.05;
  scene.effects.sliding_friction.emplace();
  const EffectStudy study = study_effects(scene, rounds(1));
  ASSERT_EQ(study.failure, "");
  EXPECT_EQ(study.prices.size(), effect_list().size());
  const EffectPrice& sliding = price_of(study, "sliding");
  EXPECT_EQ(sliding.together, std::vector<std::string>{"sliding_friction"});
  EXPECT_EQ(sliding.with.dofs, study.itself.dofs);
  EXPECT_LT(sliding.without.dofs, sliding.with.dofs);
  const EffectPrice& drag = price_of(study, "air_drag");
  EXPECT_FALSE(drag.listed);
  EXPECT_EQ(drag.without.newton_iterations, study.itself.newton_iterations);
  EXPECT_GT(drag.max_displacement_m, 0.0);
  EXPECT_NE(price_of(study, "wind").not_compared, "");
  EXPECT_NE(price_of(study, "colliders").not_compared.find("parameters"), std::string::npos);
  EXPECT_NE(price_of(study, "wrapping").not_compared.find("only stitches wrap"), std::string::npos);
}

TEST(EffectStudy, SaysWhenTheSceneDoesNotRun) {
  Scene scene = hanging_yarn();
  scene.numerics = FixedNumerics{.time_step_s = 0.01, .max_newton_iterations = 1, .smallest_step_s = 0.009};
  EXPECT_NE(study_effects(scene, rounds(1)).failure.find("converges"), std::string::npos);
}

TEST(EffectStudy, StopsAndKeepsWholeRounds) {
  int runs_begun = 0;
  std::string last;
  StudyOptions options;
  options.rounds = 50;
  options.on_progress = [&](double share, const std::string& what) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0);
    runs_begun += what != last;
    last = what;
  };
  options.should_stop = [&] { return runs_begun > 15; };
  const EffectStudy study = study_effects(falling_yarn(), options);
  EXPECT_TRUE(study.stopped);
  EXPECT_GE(study.rounds, 1);
  EXPECT_LT(study.rounds, 50);
  EXPECT_GT(price_of(study, "gravity").max_displacement_m, 0.0);
}

TEST(EffectStudy, GivesUpAVariantThatTakesTooLong) {
  StudyOptions options = rounds(2);
  options.effort_factor = 0;
  options.least_effort = 3;
  const EffectStudy study = study_effects(falling_yarn(), options);
  EXPECT_EQ(study.failure, "");
  EXPECT_NE(price_of(study, "bending").not_compared.find("without it: given up at t = "), std::string::npos)
      << price_of(study, "bending").not_compared;
}

TEST(EffectStudy, DoesNotRunASceneThatWouldBeRefused) {
  Scene scene = falling_yarn();
  Collider ball{Sphere{Vec3(0.1, 1.0, 0.0), 0.01}, 0.3, {}};
  ball.dynamic.emplace().mass_kg = 0.1;
  scene.effects.colliders.emplace().colliders = {ball};
  const EffectStudy study = study_effects(scene, rounds(1));
  EXPECT_NE(price_of(study, "inertia").not_compared.find("refused"), std::string::npos);
}

}  // namespace
}  // namespace slipstitch::testing
