// SPDX-License-Identifier: MIT
// The scenes of docs/accuracy.md. What their seconds are is measured there; here is what makes them few.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "scene_io/load_scene.h"
#include "sim/run.h"

namespace slipstitch {
namespace {

constexpr double kBaselineStep_s = 1e-3;  // of linearised implicit Euler, one linear solve each

Scene accuracy_scene(const std::string& name) {
  LoadResult loaded = load_scene_file(std::string(SLIPSTITCH_SOURCE_DIR "/scenes/accuracy/") + name + ".json");
  return std::get<LoadedScene>(loaded).scene;
}

struct Ran {
  RunSummary summary;
  std::vector<VecX> frames;  // positions
  double shortest_step_s = std::numeric_limits<double>::infinity();
};

/// By a clock that shows about the Newton iterations so far.
Ran run_with(Scene scene, const decltype(Scene::numerics)& numerics) {
  scene.numerics = numerics;
  Ran ran;
  int position_coords = 0;
  double now = 0.0;
  RunHooks hooks;
  hooks.clock = [&] { return now; };
  hooks.should_stop = [&] {
    now += 1.0;
    return false;
  };
  hooks.on_header = [&](const FrameHeader& header) { position_coords = 3 * header.topology.num_nodes; };
  hooks.on_frame = [&](const Frame& frame) { ran.frames.push_back(frame.q.head(position_coords)); };
  hooks.on_progress = [&](const Progress& p) { ran.shortest_step_s = std::min(ran.shortest_step_s, p.step_s); };
  ran.summary = run(scene, 1, hooks);
  EXPECT_EQ(ran.summary.status, RunStatus::succeeded) << ran.summary.message;
  return ran;
}

double largest_distance(const Ran& a, const Ran& b) {
  double most = 0.0;
  for (std::size_t f = 0; f < std::min(a.frames.size(), b.frames.size()); ++f) {
    const VecX apart = a.frames[f] - b.frames[f];
    for (Eigen::Index n = 0; n < apart.size(); n += 3) most = std::max(most, apart.segment<3>(n).norm());
  }
  return most;
}

class AccuracyScenes : public ::testing::TestWithParam<const char*> {};

TEST_P(AccuracyScenes, TakeFewerSolvesThanTheBaselineAndNeverStall) {
  const Scene scene = accuracy_scene(GetParam());
  const Ran coarse = run_with(scene, AccuracyNumerics{1e-2}), fine = run_with(scene, AccuracyNumerics{1e-3});
  const double baseline = scene.duration_s / kBaselineStep_s;
  std::printf("%s: %ld and %ld iterations, baseline %.0f; steps down to %.1e s\n", GetParam(),
              coarse.summary.newton_iterations, fine.summary.newton_iterations, baseline, fine.shortest_step_s);
  EXPECT_LT(static_cast<double>(coarse.summary.newton_iterations), baseline / 1.4);
  EXPECT_GT(fine.shortest_step_s, 1e-6);
  EXPECT_LT(fine.summary.steps, static_cast<long>(0.4 * baseline));
}

INSTANTIATE_TEST_SUITE_P(Six, AccuracyScenes,
                         ::testing::Values("drape", "stretch", "curl", "ball-drop", "snag", "rib-tube"),
                         [](const auto& which) {
                           std::string name = which.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(AccuracyOfScenes, TheDrapeKnowsItsError) {
  Scene scene = accuracy_scene("drape");
  scene.duration_s = 0.2;
  const Ran exact = run_with(scene, FixedNumerics{.time_step_s = 5e-4,
                                                  .velocity_tolerance_m_per_s = 1e-6,
                                                  .integrator = Integrator::sdirk2});
  for (const double tolerance : {1e-3, 1e-4}) {
    const Ran ran = run_with(scene, AccuracyNumerics{tolerance});
    const double error = largest_distance(ran, exact), estimate = ran.summary.error_estimate_m.value_or(0.0);
    std::printf("tolerance %.0e m: error %.2e, estimated %.2e\n", tolerance, error, estimate);
    EXPECT_LE(error, tolerance);
    EXPECT_LE(error, 3.0 * estimate);
    EXPECT_LE(estimate, tolerance);
  }
  for (const double budget : {150.0, 500.0}) {
    const Ran ran = run_with(scene, BudgetNumerics{budget});
    const double error = largest_distance(ran, exact), estimate = ran.summary.error_estimate_m.value_or(0.0);
    std::printf("budget %.0f: %.0f used, error %.2e, estimated %.2e\n", budget, ran.summary.wall_s, error, estimate);
    EXPECT_NEAR(ran.summary.wall_s, budget, 0.1 * budget);
    EXPECT_LE(error, 3.0 * estimate);
  }
}

}  // namespace
}  // namespace slipstitch
