// SPDX-License-Identifier: MIT
#include "study/work_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "study/study_scenes.h"

namespace slipstitch::testing {
namespace {

/// A straight yarn whose ends are pushed together: which way it buckles is decided by what noise there is.
Scene buckling_column() {
  Scene scene = hanging_yarn();
  scene.name = "column";
  scene.effects.gravity.reset();
  scene.handles = {held(0, 0), held(0, -1)};
  scene.handles[1].velocity_m_per_s = Vec3(-0.2, 0.0, 0.0);
  scene.duration_s = 0.1;
  scene.frames_per_s = 100.0;
  return scene;
}

WorkPrecisionOptions quick_on(RunShelf& shelf) {
  WorkPrecisionOptions options;
  options.quick = true;
  options.short_run_s = 1e9;  // all are
  options.shelf = &shelf;
  return options;
}

WorkPrecisionOptions whole() {
  WorkPrecisionOptions options;
  options.short_run_s = 1e9;
  return options;
}

TEST(WorkPrecision, ShowsTheOrderOfEveryMethod) {
  const WorkPrecision study = study_work_precision(smooth_swing(), whole());
  ASSERT_EQ(study.failure, "");
  EXPECT_EQ(study.rungs.size(), 41U);
  EXPECT_EQ(study.frames, 4);
  const std::pair<const char*, double> orders[] = {
      {"LINEARISED_EULER", 1.0}, {"IMPLICIT_EULER", 1.0}, {"BDF2", 2.0}, {"SDIRK2", 2.0}, {"IMPLICIT_MIDPOINT", 2.0}};
  for (const auto& [method, order] : orders) {
    const RungResult& finest = rung_of(study, method, 0);
    ASSERT_TRUE(finest.order) << method;
    EXPECT_NEAR(*finest.order, order, 0.1) << method;
    EXPECT_TRUE(finest.resolved) << method;
    EXPECT_EQ(finest.times, 3) << method;
    EXPECT_GT(finest.errors->most_m, 0.0);
    EXPECT_LT(finest.errors->rms_m, finest.errors->position_m);
    EXPECT_GT(finest.errors->stored_j, 0.0);
    EXPECT_GT(finest.errors->force_n, 0.0);
    EXPECT_GT(finest.errors->length_m, 0.0);
    EXPECT_LT(finest.errors->length_m, rung_of(study, method, 3).errors->length_m) << method;
  }
  EXPECT_EQ(study.worst_place, "point 4 of yarn 0");  // the free end
}

TEST(WorkPrecision, RefinesTheReferenceUntilItSettles) {
  const WorkPrecision study = study_work_precision(smooth_swing(), whole());
  const StudyReference& reference = study.reference;
  EXPECT_EQ(reference.method, "SDIRK2");
  EXPECT_TRUE(reference.settled);
  ASSERT_TRUE(reference.order && reference.error_m);
  EXPECT_NEAR(*reference.order, 2.0, 0.2);
  EXPECT_TRUE(reference.extrapolated);
  const double smallest = rung_of(study, "SDIRK2", 0).errors->position_m;
  EXPECT_LE(reference.change_m.back(), 0.1 * smallest);
  EXPECT_GT(reference.change_m[reference.change_m.size() - 2], 0.1 * smallest);  // and no longer
  EXPECT_LT(*reference.error_m, reference.change_m.back());
  EXPECT_FALSE(study.horizon_s);  // smooth motion
  EXPECT_LT(reference.twin_distance_m, 10.0 * kTwinNoise_m);
  EXPECT_GT(reference.twin_distance_m, 0.0);
}

TEST(WorkPrecision, FindsFromWhereOnABucklingColumnCannotBePredicted) {
  CountingShelf shelf;
  const WorkPrecision study = study_work_precision(buckling_column(), quick_on(shelf));
  ASSERT_EQ(study.failure, "");
  ASSERT_TRUE(study.horizon_s);
  EXPECT_GT(*study.horizon_s, 0.01);
  EXPECT_LT(*study.horizon_s, 0.1);
  EXPECT_GT(study.reference.twin_distance_m, 1e-3);
  for (const RungResult& r : study.rungs) {
    ASSERT_TRUE(r.errors) << rung_name(r.rung);
    EXPECT_LT(r.errors->position_m, study.reference.twin_distance_m) << rung_name(r.rung);
  }
}

TEST(WorkPrecision, ComparesNoPositionsWhereNoneCanBePredicted) {
  Scene scene = buckling_column();
  scene.frames_per_s = 10.0;  // the start and the end only
  CountingShelf shelf;
  const WorkPrecision study = study_work_precision(scene, quick_on(shelf));
  ASSERT_TRUE(study.horizon_s);
  EXPECT_NEAR(*study.horizon_s, 0.1, 1e-12);
  EXPECT_FALSE(study.reference.error_m);
  for (const RungResult& r : study.rungs) {
    ASSERT_TRUE(r.errors);
    EXPECT_TRUE(std::isnan(r.errors->position_m));
    EXPECT_TRUE(std::isfinite(r.errors->stored_j));
    EXPECT_FALSE(r.resolved || r.on_front || r.speedup);
  }
  EXPECT_EQ(study.worst_place, "");
}

TEST(WorkPrecision, RunsNothingTwice) {
  CountingShelf shelf;
  const WorkPrecision first = study_work_precision(smooth_swing(), quick_on(shelf));
  const int runs = shelf.kept;
  EXPECT_EQ(runs, 3 * 24 + static_cast<int>(shelf.size()) - 24);  // rungs three times, references and twins once
  const WorkPrecision again = study_work_precision(smooth_swing(), quick_on(shelf));
  EXPECT_EQ(shelf.kept, runs);
  ASSERT_EQ(again.rungs.size(), first.rungs.size());
  for (std::size_t i = 0; i < first.rungs.size(); ++i) {
    EXPECT_EQ(again.rungs[i].wall_s, first.rungs[i].wall_s);
    EXPECT_EQ(again.rungs[i].errors->position_m, first.rungs[i].errors->position_m);
  }
}

TEST(WorkPrecision, RunsLongOnesOnce) {
  CountingShelf shelf;
  WorkPrecisionOptions options = quick_on(shelf);
  options.short_run_s = 0.0;
  const WorkPrecision study = study_work_precision(smooth_swing(), options);
  EXPECT_EQ(shelf.kept, static_cast<int>(shelf.size()));
  for (const RungResult& r : study.rungs) EXPECT_EQ(r.times, 1);
}

TEST(WorkPrecision, GoesOnWhereItWasStopped) {
  CountingShelf shelf;
  WorkPrecisionOptions options = quick_on(shelf);
  options.should_stop = [&] { return shelf.kept >= 7; };
  const WorkPrecision stopped = study_work_precision(smooth_swing(), options);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(shelf.kept, 7);
  options.should_stop = {};
  const WorkPrecision rest = study_work_precision(smooth_swing(), options);
  EXPECT_FALSE(rest.stopped);
  CountingShelf fresh;
  study_work_precision(smooth_swing(), quick_on(fresh));
  EXPECT_EQ(shelf.kept, fresh.kept);
}

/// Every run takes ten seconds of the study's clock.
WorkPrecision with_budget(CountingShelf& shelf, double budget_s) {
  WorkPrecisionOptions options = quick_on(shelf);
  const int before = shelf.kept;
  options.budget_s = budget_s;
  options.clock_s = [&shelf, before] { return 10.0 * (shelf.kept - before); };
  return study_work_precision(smooth_swing(), options);
}

TEST(WorkPrecision, KeepsToItsBudgetAndNamesWhatDidNotFit) {
  CountingShelf shelf;
  const WorkPrecision study = with_budget(shelf, 240.0);
  EXPECT_EQ(study.failure, "");
  EXPECT_LE(shelf.kept, 24);
  std::set<std::string> missing;
  int run = 0;
  for (const RungResult& r : study.rungs) {
    if (r.no_result.empty()) {
      ++run;
      EXPECT_TRUE(r.errors);
    } else {
      EXPECT_FALSE(r.failed);
      EXPECT_NE(r.no_result.find("did not fit"), std::string::npos);
      missing.insert(rung_name(r.rung));
    }
  }
  EXPECT_EQ(run, 8);  // a third of the time, the coarse ones of every method first
  EXPECT_TRUE(missing.contains("SDIRK2 4.17 ms"));
  EXPECT_FALSE(missing.contains("IMPLICIT_MIDPOINT 16.7 ms"));
  EXPECT_EQ(study.reference.failure, "");
}

TEST(WorkPrecision, DoesNotBeginWhatWillNotFit) {
  CountingShelf shelf;
  shelf.wall_s = 50.0;
  with_budget(shelf, 3.0 * 51.0);  // the coarsest of every method
  const WorkPrecision study = with_budget(shelf, 3.0 * 99.0);
  for (const RungResult& r : study.rungs) {
    // The next would take a hundred seconds.
    const bool coarsest = r.rung.size > (r.rung.method == kAccuracyMethod ? 5e-3 : 0.01);
    EXPECT_EQ(r.no_result.empty(), coarsest) << rung_name(r.rung);
  }
}

TEST(WorkPrecision, SaysThatThereWasNoTimeForATwinOrAReference) {
  CountingShelf shelf;
  const WorkPrecision first = with_budget(shelf, 5.0);
  EXPECT_EQ(shelf.kept, 1);
  EXPECT_FALSE(first.rungs[0].errors);
  EXPECT_NE(first.reference.failure.find("no time"), std::string::npos) << first.reference.failure;
  CountingShelf other;
  const WorkPrecision second = with_budget(other, 12.0);
  EXPECT_EQ(other.kept, 2);
  EXPECT_TRUE(second.rungs[0].errors);
  EXPECT_EQ(second.reference.failure, "");
  EXPECT_FALSE(second.reference.twin_step_s);
  EXPECT_TRUE(second.reference.out_of_time);
}

TEST(WorkPrecision, FindsNoOrderFromStepsThatAreNotHalves) {
  CountingShelf shelf;
  const WorkPrecision study = with_budget(shelf, 3.0 * 61.0);
  EXPECT_EQ(rung_of(study, "SDIRK2", 3).no_result, "");  // 16.7 ms, and the baseline half of that
  EXPECT_NE(rung_of(study, "SDIRK2", 2).no_result, "");
  EXPECT_NEAR(study.reference.step_s, 1.0 / 240 / (1 << (study.reference.refinements - 1)), 1e-9);
  ASSERT_EQ(study.reference.change_m.size(), static_cast<std::size_t>(study.reference.refinements));
  EXPECT_EQ(study.reference.order.has_value(), study.reference.refinements > 2);
  EXPECT_TRUE(study.reference.error_m);
}

TEST(WorkPrecision, KeepsWhatIsThereWhenTheTimeIsUp) {
  CountingShelf shelf;
  const WorkPrecision whole_study = study_work_precision(smooth_swing(), quick_on(shelf));
  const int runs = shelf.kept;
  const WorkPrecision study = with_budget(shelf, 1e-9);
  EXPECT_EQ(shelf.kept, runs);
  for (const RungResult& r : study.rungs) EXPECT_TRUE(r.errors) << rung_name(r.rung);
  EXPECT_GT(study.reference.refinements, 1);
  EXPECT_EQ(study.reference.step_s, whole_study.reference.step_s);
  EXPECT_EQ(study.reference.error_m, whole_study.reference.error_m);
}

TEST(WorkPrecision, ListsWhatFailsAndNamesItWhereNothingRuns) {
  Scene scene = smooth_swing();
  scene.numerics = FixedNumerics{.max_newton_iterations = 1, .smallest_step_s = 1e-3};
  CountingShelf shelf, still_shelf, out_shelf;  // one a scene
  const WorkPrecision study = study_work_precision(scene, quick_on(shelf));
  EXPECT_EQ(rung_of(study, "LINEARISED_EULER", 0).no_result, "");
  const RungResult& failed = rung_of(study, "IMPLICIT_EULER", 0);
  EXPECT_TRUE(failed.failed);
  EXPECT_NE(failed.no_result.find("converges"), std::string::npos) << failed.no_result;
  EXPECT_NE(study.reference.failure.find("converges"), std::string::npos) << study.reference.failure;
  EXPECT_EQ(study.failure, "");
  scene.effects.inertia.reset();
  const WorkPrecision still = study_work_precision(scene, quick_on(still_shelf));
  for (const RungResult& r : still.rungs) EXPECT_EQ(r.failed, r.rung.method == kStaticMethod) << rung_name(r.rung);
  scene = crossed_yarns();
  scene.yarns[1].points = {Vec3(0.1, 0.0, -0.1), Vec3(0.1, 0.0, 0.0), Vec3(0.1, 0.0, 0.05)};
  scene.crossings = {{0, 2, 1, 1}};
  scene.handles = {held(0, 0), held(0, 2), held(0, -1), held(1, 0)};
  scene.handles[3].velocity_m_per_s = Vec3(0.0, 0.0, -2.0);  // out of the crossing
  scene.duration_s = 0.1;
  const WorkPrecision out = study_work_precision(scene, quick_on(out_shelf));
  EXPECT_NE(out.failure.find("a yarn end was pulled"), std::string::npos) << out.failure;
  for (const RungResult& r : out.rungs) EXPECT_TRUE(r.failed) << rung_name(r.rung);
  scene = smooth_swing();
  scene.duration_s = 0.0;
  EXPECT_NE(study_work_precision(scene, {}).failure, "");
}

TEST(WorkPrecision, EndsWhenResultsCannotBeKept) {
  CountingShelf shelf;
  shelf.error = "the disk is full";
  const WorkPrecision study = study_work_precision(smooth_swing(), quick_on(shelf));
  EXPECT_EQ(study.failure, "the disk is full");
  EXPECT_EQ(shelf.kept, 1);
}

TEST(WorkPrecision, ComparesStaticSolvesByStepAndForceTolerance) {
  Scene scene = smooth_swing();
  scene.effects.inertia.reset();
  scene.effects.damping.reset();
  CountingShelf shelf;
  const WorkPrecision study = study_work_precision(scene, quick_on(shelf));
  ASSERT_EQ(study.failure, "");
  EXPECT_EQ(study.reference.method, kStaticMethod);
  for (const RungResult& r : study.rungs) {
    EXPECT_TRUE(r.rung.method == kStaticMethod || r.rung.method == kAccuracyMethod) << r.rung.method;
    ASSERT_TRUE(r.errors);
    EXPECT_FALSE(r.speedup);  // there is no baseline
  }
  const auto error = [&](std::size_t from_finest) { return rung_of(study, "STATIC", from_finest).errors->position_m; };
  EXPECT_GT(error(2), error(0));  // the loosest tolerance
}

TEST(WorkPrecision, ProgressGoesUp) {
  CountingShelf shelf;
  WorkPrecisionOptions options = quick_on(shelf);
  double last = 0.0;
  std::set<std::string> names;
  options.on_progress = [&](double share, const std::string& what) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    names.insert(what);
  };
  study_work_precision(smooth_swing(), options);
  EXPECT_GT(last, 0.5);
  EXPECT_TRUE(names.contains("BDF2 4.17 ms"));
  EXPECT_TRUE(std::any_of(names.begin(), names.end(),
                          [](const std::string& name) { return name.find("noise") != std::string::npos; }));
}

}  // namespace
}  // namespace slipstitch::testing
