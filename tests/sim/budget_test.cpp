// SPDX-License-Identifier: MIT
// Runs with a budget of wall time, by a clock that only linear solves move.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "sim/run.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

/// What a clock shows that stands still but for linear algebra.
struct Cost {
  double factor_s = 1.0, solve_s = 0.2;
  double setup_s = 0.0;      // before the first step
  double dearer = 1.0;       // times as much,
  double dearer_from_s = 0;  // from this simulated time on
};

class TimedSolver final : public LinearSolver {
 public:
  TimedSolver(double& now, const double& t, const Cost& cost) : now_(now), t_(t), cost_(cost) {}
  LinearStatus factor(const SparseMatrix& a) override {
    now_ += cost_.factor_s * (t_ >= cost_.dearer_from_s ? cost_.dearer : 1.0);
    return inner_->factor(a);
  }
  LinearStatus solve(const VecX& b, VecX& x) override {
    now_ += cost_.solve_s * (t_ >= cost_.dearer_from_s ? cost_.dearer : 1.0);
    return inner_->solve(b, x);
  }
  std::string name() const override { return inner_->name(); }

 private:
  std::unique_ptr<LinearSolver> inner_ = make_cholmod_solver();
  double& now_;
  const double& t_;
  const Cost& cost_;
};

struct Ran {
  RunSummary summary;
  std::vector<VecX> frames;
  double estimate() const { return summary.error_estimate_m.value_or(0.0); }
};

Ran run_timed(const Scene& scene, const Cost& cost) {
  Ran ran;
  double now = 1000.0, t = 0.0;
  RunHooks hooks;
  hooks.clock = [&] { return now; };
  hooks.on_start = [&](Simulation&) { now += cost.setup_s; };
  hooks.make_solver = [&] { return std::make_unique<TimedSolver>(now, t, cost); };
  hooks.on_frame = [&](const Frame& frame) { ran.frames.push_back(frame.q); };
  hooks.on_progress = [&](const Progress& progress) { t = progress.t; };
  ran.summary = run(scene, 1, hooks);
  EXPECT_EQ(ran.summary.status, RunStatus::succeeded) << ran.summary.message;
  return ran;
}

Ran run_within(Scene scene, double budget_s, const Cost& cost = {}) {
  scene.numerics = BudgetNumerics{budget_s};
  Ran ran = run_timed(scene, cost);
  const RunSummary& s = ran.summary;
  std::printf("%s, %g s: %.4g s, estimate %.2e m, as to %.2e m, %ld steps, %ld rejected, %.0f %% at the loosest\n",
              scene.name.c_str(), budget_s, s.wall_s, ran.estimate(), s.budget->same_tolerance_m.value_or(0.0), s.steps,
              s.rejected_steps, 100.0 * s.budget->share_at_loosest);
  return ran;
}

Ran run_to(Scene scene, double tolerance_m, const Cost& cost = {}) {
  scene.numerics = AccuracyNumerics{tolerance_m};
  Ran ran = run_timed(scene, cost);
  std::printf("%s to %g m: %.4g s, estimate %.2e m, %ld steps\n", scene.name.c_str(), tolerance_m, ran.summary.wall_s,
              ran.estimate(), ran.summary.steps);
  return ran;
}

Scene smooth() {
  Scene scene = smooth_motion();
  scene.name = "smooth";
  scene.duration_s = 0.2;
  scene.frames_per_s = 50.0;
  return scene;
}

/// A yarn that swings down from one end and meets the ground halfway through the run.
Scene slap() {
  Scene scene = hanging_yarn();
  scene.name = "slap";
  scene.yarn.stretch_n = 50.0;
  scene.effects.colliders.emplace().colliders = {{Plane{{0.0, -0.04, 0.0}, Vec3::UnitY()}, 0.3, {}}};
  scene.effects.damping = DampingEffect{1e-2, 1e-5, 0.0, 0.0};
  scene.duration_s = 0.2;
  scene.frames_per_s = 50.0;
  return scene;
}

Ran run_exactly(Scene scene, double step_s) {
  scene.numerics =
      FixedNumerics{.time_step_s = step_s, .velocity_tolerance_m_per_s = 1e-9, .integrator = Integrator::sdirk2};
  return run_timed(scene, {});
}

/// Largest distance between the same nodes in the same frames.
double largest_distance(const Ran& a, const Ran& b, int nodes) {
  double most = 0.0;
  for (std::size_t f = 0; f < std::min(a.frames.size(), b.frames.size()); ++f)
    for (int n = 0; n < nodes; ++n) most = std::max(most, (a.frames[f] - b.frames[f]).segment<3>(3 * n).norm());
  return most;
}

TEST(Budget, IsMetWhateverASolveCosts) {
  for (const Cost& cost : {Cost{.factor_s = 1.0, .solve_s = 0.2}, Cost{.factor_s = 0.1, .solve_s = 0.02},
                           Cost{.factor_s = 0.5, .solve_s = 3.0}, Cost{.setup_s = 1000.0}}) {
    const Ran ran = run_within(smooth(), 2000.0, cost);
    EXPECT_NEAR(ran.summary.wall_s, 2000.0, 200.0);
    EXPECT_TRUE(ran.summary.budget->kept);
  }
}

// All the error is that of the first pairs, in which the yarn springs to its balance: more time does not help.
TEST(Budget, IsNotExceededWhereThereIsLittleToGain) {
  Scene scene = hanging_yarn();
  scene.name = "static";
  scene.effects.inertia.reset();
  scene.handles.push_back(held(0, -1));
  scene.handles[1].velocity_m_per_s = Vec3(-0.2, 0.0, 0.0);
  scene.effects.damping = DampingEffect{1e-3, 1e-5, 0.0, 0.0};
  scene.duration_s = 0.2;
  scene.frames_per_s = 10.0;
  const Ran less = run_within(scene, 500.0), more = run_within(scene, 5000.0);
  EXPECT_LT(less.summary.wall_s, 550.0);
  EXPECT_LT(more.summary.wall_s, 5500.0);
  EXPECT_LT(more.estimate(), 0.5 * less.estimate());
}

TEST(Budget, MoreOfItMakesTheEstimateSmaller) {
  double before = 1.0;
  for (const double budget_s : {500.0, 1000.0, 2000.0, 4000.0}) {
    const double estimate = run_within(smooth(), budget_s).estimate();
    EXPECT_LT(estimate, 0.7 * before);
    before = estimate;
  }
}

TEST(Budget, LeavesTheEstimateHonest) {
  const Ran exact = run_exactly(smooth(), 0.2 / 16384);
  for (const double budget_s : {500.0, 2000.0, 5000.0}) {
    const Ran ran = run_within(smooth(), budget_s);
    const double error = largest_distance(ran, exact, 10);
    std::printf("error %.2e m\n", error);
    EXPECT_LE(error, 3.0 * ran.estimate());
    EXPECT_GE(error, ran.estimate() / 3.0);
  }
}

TEST(Budget, GivesWhatItsEqualToleranceGives) {
  for (const double budget_s : {1000.0, 4000.0}) {
    const Ran ran = run_within(smooth(), budget_s);
    const Ran same = run_to(smooth(), ran.summary.budget->same_tolerance_m.value());
    EXPECT_NEAR(same.summary.wall_s, budget_s, 0.3 * budget_s);
    EXPECT_LT(ran.estimate(), 3.0 * same.estimate());
    EXPECT_GT(ran.estimate(), same.estimate() / 3.0);
  }
}

TEST(Budget, HoldsWhereCostsRiseOnTheWay) {
  for (const double budget_s : {1000.0, 2000.0}) {
    EXPECT_LT(run_within(slap(), budget_s).summary.wall_s, 1.25 * budget_s);
    const Cost rises{.dearer = 3.0, .dearer_from_s = 0.1};
    EXPECT_LT(run_within(smooth(), budget_s, rises).summary.wall_s, 1.25 * budget_s);
  }
}

TEST(Budget, ThatIsFarTooSmallStillEndsAndSaysSo) {
  const Ran ran = run_within(smooth(), 50.0);
  EXPECT_EQ(ran.summary.status, RunStatus::succeeded);
  EXPECT_EQ(ran.frames.size(), 11U);
  ASSERT_TRUE(ran.summary.budget);
  EXPECT_FALSE(ran.summary.budget->kept);
  EXPECT_GT(ran.summary.wall_s, 100.0);
  EXPECT_DOUBLE_EQ(ran.summary.budget->share_at_loosest, 1.0);
  EXPECT_DOUBLE_EQ(ran.summary.budget->loosest_tolerance_m, 10.0 * smooth().yarn.radius_m);
  EXPECT_GT(ran.estimate(), 0.0);
}

// With the time gone before it begins there is no trial, and all else is the same.
TEST(Budget, TheTrialLeavesNoTrace) {
  Scene swatch = free_swatch(3, 3);
  swatch.effects.plasticity.emplace();
  swatch.frames_per_s = 100.0;
  swatch.duration_s = 0.2;
  Scene yarn = slap();
  yarn.duration_s = 0.6;
  for (const Scene& scene : {yarn, swatch}) {
    const Ran tried = run_within(scene, 400.0), untried = run_within(scene, 400.0, {.setup_s = 401.0});
    EXPECT_NEAR(tried.summary.budget->share_at_loosest, 1.0, 1e-9);
    EXPECT_NEAR(untried.summary.budget->share_at_loosest, 1.0, 1e-9);
    EXPECT_GT(tried.summary.newton_iterations, untried.summary.newton_iterations + 15) << "a pair takes about 10";
    EXPECT_EQ(tried.summary.steps, untried.summary.steps);
    EXPECT_EQ(tried.summary.state_hash, untried.summary.state_hash);
    EXPECT_EQ(tried.summary.error_estimate_m, untried.summary.error_estimate_m);
  }
}

TEST(Budget, IsToldWithTheProgress) {
  Scene scene = smooth();
  scene.numerics = BudgetNumerics{500.0};
  double now = 0.0, t = 0.0, before_s = 0.0;
  long trials = 0, later = 0;
  RunHooks hooks;
  hooks.clock = [&] { return now; };
  hooks.began_s = -100.0;
  const Cost cost;
  hooks.make_solver = [&] { return std::make_unique<TimedSolver>(now, t, cost); };
  hooks.on_progress = [&](const Progress& progress) {
    EXPECT_EQ(progress.budget_s, 500.0);
    EXPECT_GE(progress.wall_s, 100.0);
    EXPECT_GE(progress.before_s, before_s);
    before_s = progress.before_s;
    (progress.doing.empty() ? later : trials) += 1;
    EXPECT_TRUE(progress.doing.empty() || (later == 0 && progress.t == 0.0)) << progress.doing;
  };
  const RunSummary summary = run(scene, 1, hooks);
  EXPECT_GT(trials, 2);
  EXPECT_GT(later, 20);
  EXPECT_NEAR(summary.wall_s, 500.0, 50.0) << "100 s of it before run() was called";
}

}  // namespace
}  // namespace slipstitch::testing
