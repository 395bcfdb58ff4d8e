// SPDX-License-Identifier: MIT
#include "study/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/run.h"
#include "study/study_scenes.h"
#include "study/varied_scenes.h"

namespace slipstitch::testing {
namespace {

/// A run that takes `rate` iterations a second, and two a step.
RunCourse even_course(double duration_s, double rate) {
  RunCourse course;
  for (int i = 1; i <= 10; ++i) {
    const double t = 0.1 * i * duration_s;
    course.push_back({t, 0.5 * rate * t, rate * t});
  }
  return course;
}

ProblemSize size_of(double nonzeros, double operations) { return {100, nonzeros, {10.0 * nonzeros, operations}}; }

TEST(CostModel, FindsTheCostsThatTimesWereMadeOf) {
  const IterationCost made{2e-7, 3e-10};
  std::vector<TimedIterations> timed;
  for (const ProblemSize& size : {size_of(1e4, 1e6), size_of(1e5, 1e8)}) {
    const double iterations = 20.0, factor_s = iterations * made.per_operation_s * size.factor.operations;
    timed.push_back({size, iterations, iterations * iteration_s(made, size), factor_s});
  }
  timed.push_back({size_of(1e9, 1e12), 0.0, 0.0, 0.0});  // never got to its first step
  const IterationCost found = fit_cost(timed);
  EXPECT_NEAR(found.per_nonzero_s, made.per_nonzero_s, 1e-12);
  EXPECT_NEAR(found.per_operation_s, made.per_operation_s, 1e-15);
  EXPECT_NEAR(iteration_s(found, size_of(1e6, 1e9)), 0.2 + 0.3, 1e-6);
}

TEST(CostModel, HasNoNegativeCosts) {
  const TimedIterations odd{size_of(1e4, 1e6), 10.0, 0.1, 0.2};  // more in factorisations than in all
  const IterationCost found = fit_cost({&odd, 1});
  EXPECT_EQ(found.per_nonzero_s, 0.0);
  EXPECT_GT(found.per_operation_s, 0.0);
}

TEST(CostModel, ScalesTheFactorOfASheet) {
  const ProblemSize known{1000, 1e4, {1e5, 1e7}};
  const FactorSize same = scaled_factor(known, 1000), four = scaled_factor(known, 4000);
  EXPECT_DOUBLE_EQ(same.entries, 1e5);
  EXPECT_DOUBLE_EQ(same.operations, 1e7);
  EXPECT_NEAR(four.operations, 8e7, 1.0);
  EXPECT_NEAR(four.entries, 4e5 * std::log(4000.0) / std::log(1000.0), 1.0);
}

TEST(Extrapolation, GoesOnEvenly) {
  const RunCourse begun = even_course(0.1, 500.0);
  const RunPoint same = extrapolate(begun, 1.0, even_course(0.3, 500.0));
  EXPECT_NEAR(same.iterations, 500.0, 1e-9);
  EXPECT_NEAR(same.steps, 250.0, 1e-9);
  // Of another machine's pace, or a dearer scene: twenty-five steps all but outweigh the model.
  EXPECT_NEAR(extrapolate(begun, 1.0, even_course(0.3, 40.0)).iterations, 500.0, 50.0);
}

TEST(Extrapolation, KnowsAWholeRunAndTakesTheModelForNone) {
  const RunCourse whole = even_course(1.0, 70.0), model = even_course(1.0, 10.0);
  EXPECT_NEAR(extrapolate(whole, 1.0, model).iterations, 70.0, 1e-9);
  EXPECT_NEAR(extrapolate({}, 2.0, model).iterations, 20.0, 1e-9);
}

// A run that begins with settling, as the model does: most of what it takes is at its start.
TEST(Extrapolation, TakesSettlingForNoMoreThanItIs) {
  RunCourse model{{0.01, 10.0, 100.0}};
  for (int i = 1; i < 100; ++i) model.push_back({0.01 * (i + 1), 10.0 + i, 100.0 + i});
  const RunCourse begun{{0.005, 20.0, 150.0}, {0.01, 30.0, 300.0}};
  const double expected = 300.0 + std::pow(3.0, 30.0 / 31.0) * 99.0;
  const double found = extrapolate(begun, 1.0, model).iterations;
  EXPECT_GT(found, expected);
  EXPECT_LT(found, 1.05 * expected);
}

TEST(Extrapolation, NeverFallsBelowWhatIsDone) {
  const RunCourse begun = even_course(0.9, 100.0);
  EXPECT_GE(extrapolate(begun, 1.0, RunPoint{1.0, 1.0, 1.0}).iterations, 90.0);
}

TEST(Extrapolation, ToTenTimesTheAccuracyTakesStepsOfASecondOrderMethod) {
  const RunPoint fine = at_tolerance({1.0, 30.0, 100.0}, 1e-2, 1e-4);
  EXPECT_NEAR(fine.steps, 300.0, 1e-9);
  EXPECT_NEAR(fine.iterations, 1000.0, 1e-9);
}

/// Of a machine on which an entry takes 0.2 us, with the courses of the canned swatch.
const Calibration& test_calibration() {
  static const Calibration calibration = [] {
    double now = 0.0;
    Calibration made = calibrate([now]() mutable { return now += 1e-4; });
    made.cost = {2e-7, 1e-10};
    return made;
  }();
  return calibration;
}

/// Nothing in it depends on a real clock: this one stands still, so that only counted iterations end a pilot.
Prediction predicted(const Scene& scene, double budget_s) {
  return predict(scene, {&test_calibration(), [] { return 0.0; }, budget_s});
}

TEST(Calibration, OfTheCannedSwatchIsSound) {
  EXPECT_TRUE(is_sound(test_calibration()));
  EXPECT_GT(test_calibration().sheet.dofs, 1000);
  EXPECT_NEAR(test_calibration().fixed.back().t, 0.1, 1e-9);
  EXPECT_NEAR(test_calibration().accurate.back().t, 0.1, 1e-9);
  Calibration bad = test_calibration();
  bad.fixed.clear();
  EXPECT_FALSE(is_sound(bad));
  bad = test_calibration();
  bad.cost.per_nonzero_s = -1.0;
  EXPECT_FALSE(is_sound(bad));
}

TEST(Pilot, StopsWhenItsIterationsWouldTakeMore) {
  IterationCost cost;
  cost.per_nonzero_s = 1e-4;
  const Pilot begun = run_pilot(smooth_swing(), {0.1, cost}, [] { return 0.0; });
  EXPECT_FALSE(begun.finished);
  EXPECT_TRUE(begun.failure.empty());
  ASSERT_FALSE(begun.course.empty());
  EXPECT_LE(begun.course.back().iterations * begun.size.nonzeros * 1e-4, 0.1);
  EXPECT_GE(begun.size.factor.entries, static_cast<double>(begun.size.dofs));
  EXPECT_GT(begun.size.factor.operations, begun.size.factor.entries);
}

TEST(Pilot, StopsByTheClock) {
  double now = 0.0;
  const Pilot begun = run_pilot(free_swatch(6, 6), {0.1, {}}, [&] { return now += 2e-3; });
  EXPECT_FALSE(begun.finished);
  EXPECT_LE(begun.wall_s, 0.12);
}

TEST(Prediction, OfAShortRunIsTheRun) {
  const Scene scene = smooth_swing();
  const Prediction found = predicted(scene, 1e9);
  const RunSummary ran = run(scene, 1, {});
  ASSERT_TRUE(found.as_it_is);
  EXPECT_EQ(found.as_it_is->steps, static_cast<double>(ran.steps));
  EXPECT_EQ(found.as_it_is->iterations, static_cast<double>(ran.newton_iterations));
  EXPECT_EQ(found.as_it_is_basis.basis, Basis::whole_run);
  EXPECT_EQ(found.dofs, ran.dofs);
  EXPECT_EQ(found.hessian_nonzeros, ran.nonzeros);
  ASSERT_EQ(found.to_tolerance.size(), 3U);
  EXPECT_EQ(found.to_tolerance_basis.basis, Basis::whole_run);
}

// Where there was time to run it to a tolerance, that is what it takes, whatever the finer ones would.
TEST(Prediction, ToAToleranceThatWasTriedIsTheRun) {
  Scene scene = smooth_swing();
  const Prediction found = predicted(scene, 1e9);
  for (const std::size_t i : {0U, 2U}) {
    scene.numerics = AccuracyNumerics{found.to_tolerance[i].tolerance_m};
    EXPECT_NEAR(found.to_tolerance[i].run.iterations, static_cast<double>(run(scene, 1, {}).newton_iterations), 0.1);
  }
}

TEST(Prediction, OfARunWithABudgetIsTheBudgetAndWhatThatComesTo) {
  Scene scene = smooth_swing();
  const Prediction free = predicted(scene, 1e9);
  const double fine_s = free.to_tolerance[2].run.wall_s;
  scene.numerics = BudgetNumerics{4.0 * fine_s};
  const Prediction found = predicted(scene, 1e9);
  ASSERT_TRUE(found.as_it_is);
  EXPECT_FALSE(found.least_steps);
  EXPECT_NEAR(found.as_it_is->wall_s, 4.0 * fine_s, 0.5 * fine_s);
  EXPECT_LT(found.budget_tolerance_m, 1e-5);
  scene.numerics = BudgetNumerics{1e-9};
  const Prediction least = predicted(scene, 1e9);
  EXPECT_GT(least.as_it_is->wall_s, 1e-9);
  EXPECT_DOUBLE_EQ(least.budget_tolerance_m, 10.0 * scene.yarn.radius_m);
  scene.effects.inertia.reset();
  EXPECT_EQ(predicted(scene, 0.0).as_it_is->wall_s, 1e-9);
}

TEST(Prediction, WithoutABudgetRestsOnTheCannedRun) {
  const Prediction found = predicted(smooth_swing(), 0.0);
  ASSERT_TRUE(found.as_it_is);
  EXPECT_EQ(found.as_it_is_basis.basis, Basis::canned_run);
  EXPECT_EQ(found.as_it_is->steps, static_cast<double>(*found.least_steps));
  EXPECT_GT(found.as_it_is->wall_s, 0.0);
  EXPECT_LT(found.to_tolerance[0].run.wall_s, found.to_tolerance[2].run.wall_s);
}

TEST(Prediction, OfAStaticSolveIsKnownOnlyWhereItIsSoonOver) {
  Scene scene = hanging_yarn();
  scene.effects.inertia.reset();
  scene.handles.push_back(held(0, -1));
  scene.duration_s = scene.frames_per_s = 1.0;
  std::get<FixedNumerics>(scene.numerics).time_step_s = 1.0;
  EXPECT_TRUE(predicted(scene, 1e9).as_it_is);
  EXPECT_FALSE(predicted(scene, 0.0).as_it_is);
  EXPECT_TRUE(predicted(scene, 1e9).to_tolerance.empty());
}

TEST(Prediction, SaysWhyTheRunFails) {
  Scene scene = smooth_swing();
  auto& numerics = std::get<FixedNumerics>(scene.numerics);
  numerics.max_newton_iterations = 1;
  numerics.smallest_step_s = 0.9 * numerics.time_step_s;
  numerics.velocity_tolerance_m_per_s = 1e-12;
  EXPECT_NE(predicted(scene, 1e9).run_fails.find("no step above"), std::string::npos);
}

// --- Against runs ---------------------------------------------------------------------------------------------------

// Each pilot may make a tenth of the iterations that the run is then found to make.
TEST(Prediction, IsWithinAFactorOfTwoForEightOfTenScenes) {
  int good = 0;
  std::string all;
  for (const Scene& scene : varied_scenes()) {
    ASSERT_TRUE(check(scene).empty()) << check(scene)[0].path << ' ' << check(scene)[0].expected;
    const RunSummary ran = run(scene, 1, {});
    ASSERT_EQ(ran.status, RunStatus::succeeded) << ran.message;
    const double tenth = 0.1 * static_cast<double>(ran.newton_iterations) * 2e-7 * static_cast<double>(ran.nonzeros);
    const Prediction found =
        predicted(scene, std::holds_alternative<AccuracyNumerics>(scene.numerics) ? tenth : 2.5 * tenth);
    ASSERT_TRUE(found.as_it_is);
    EXPECT_NE(found.as_it_is_basis.basis, Basis::whole_run);
    const double off = found.as_it_is->iterations / static_cast<double>(ran.newton_iterations);
    const double steps_off = found.as_it_is->steps / static_cast<double>(ran.steps);
    good += std::max({off, 1.0 / off, steps_off, 1.0 / steps_off}) <= 2.0 ? 1 : 0;
    all += scene.name + " " + std::to_string(ran.newton_iterations) + " iterations, off by " + std::to_string(off) +
           ", steps " + std::to_string(steps_off) + ", from " + std::to_string(found.as_it_is_basis.until_s) + " s\n";
  }
  EXPECT_GE(good, 8) << all;
  RecordProperty("predictions", all);
}

}  // namespace
}  // namespace slipstitch::testing
