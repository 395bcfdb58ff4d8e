// SPDX-License-Identifier: MIT
// A tolerance is kept, and the run knows how well.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "sim/run.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

struct Ran {
  RunSummary summary;
  std::vector<VecX> frames;
  std::vector<double> estimates;  // with every frame
  std::vector<double> times;      // of all steps' ends
  double shortest = 1.0;          // step [s]
};

Ran run_and_keep(const Scene& scene) {
  Ran ran;
  RunHooks hooks;
  hooks.on_frame = [&](const Frame& frame) { ran.frames.push_back(frame.q); };
  hooks.on_frame_report = [&](const FrameReport& report) {
    ran.estimates.push_back(report.error_estimate_m.value_or(-1.0));
  };
  hooks.on_progress = [&](const Progress& progress) {
    ran.times.push_back(progress.t);
    ran.shortest = std::min(ran.shortest, progress.step_s);
  };
  ran.summary = run(scene, 1, hooks);
  EXPECT_EQ(ran.summary.status, RunStatus::succeeded) << ran.summary.message;
  return ran;
}

Ran run_to(Scene scene, double tolerance_m) {
  scene.numerics = AccuracyNumerics{tolerance_m};
  return run_and_keep(scene);
}

/// By equal steps of second order, as short as it takes.
Ran run_exactly(Scene scene, double step_s) {
  scene.numerics =
      FixedNumerics{.time_step_s = step_s, .velocity_tolerance_m_per_s = 1e-9, .integrator = Integrator::sdirk2};
  return run_and_keep(scene);
}

/// Largest distance between the same nodes, frame by frame.
std::vector<double> distances(const Ran& a, const Ran& b, int nodes) {
  std::vector<double> result;
  for (std::size_t f = 0; f < std::min(a.frames.size(), b.frames.size()); ++f) {
    double most = 0.0;
    for (int n = 0; n < nodes; ++n) most = std::max(most, (a.frames[f] - b.frames[f]).segment<3>(3 * n).norm());
    result.push_back(most);
  }
  return result;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

Scene smooth_for(double duration_s) {
  Scene scene = smooth_motion();
  scene.duration_s = duration_s;
  scene.frames_per_s = 50.0;
  return scene;
}

TEST(AccurateSteps, KeepTheToleranceAndKnowTheErrorWhereMotionIsSmooth) {
  const Scene scene = smooth_for(0.2);
  const Ran exact = run_exactly(scene, 0.2 / 16384);
  const int nodes = 10;
  double before = 0.0;
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Ran ran = run_to(scene, tolerance);
    const double error = largest(distances(ran, exact, nodes));
    const double estimate = ran.summary.error_estimate_m.value_or(0.0);
    std::printf("tolerance %.0e m: error %.2e, estimated %.2e, %ld steps\n", tolerance, error, estimate,
                ran.summary.steps);
    EXPECT_LE(error, tolerance);
    EXPECT_LE(error, 3.0 * estimate);
    EXPECT_GE(error, estimate / 3.0);
    EXPECT_FALSE(ran.summary.predictable_until_s.has_value());
    EXPECT_DOUBLE_EQ(largest(ran.estimates), estimate);
    // Steps as the square root of the error, and not much more.
    if (before > 0.0) {
      EXPECT_LT(static_cast<double>(ran.summary.steps), 6.0 * before);
    }
    before = static_cast<double>(ran.summary.steps);
  }
}

/// A yarn that falls onto the ground, bounces and is dragged over it by one end.
Scene dragged_yarn() {
  Scene scene = hanging_yarn();
  for (Vec3& p : scene.yarns[0].points) p.y() = 1.5e-3;
  scene.handles[0].velocity_m_per_s = Vec3(-0.1, 0.0, 0.05);
  scene.effects.colliders.emplace().colliders = {{Plane{Vec3::Zero(), Vec3::UnitY()}, 0.3, {}}};
  scene.effects.damping = DampingEffect{1e-2, 1e-5, 0.0, 0.0};
  scene.duration_s = 0.2;
  scene.frames_per_s = 50.0;
  return scene;
}

TEST(AccurateSteps, NeitherStallNorStrayWhereYarnTouchesAndSlips) {
  const Scene scene = dragged_yarn();
  const Ran exact = run_exactly(scene, 2e-5);
  for (const double tolerance : {1e-3, 1e-4}) {
    const Ran ran = run_to(scene, tolerance);
    const std::vector<double> errors = distances(ran, exact, 5);
    std::printf("tolerance %.0e m: error %.2e, estimated %.2e, %ld steps, shortest %.1e s, lost at %g s\n", tolerance,
                largest(errors), ran.summary.error_estimate_m.value_or(0.0), ran.summary.steps, ran.shortest,
                ran.summary.predictable_until_s.value_or(-1.0));
    EXPECT_GE(ran.shortest, 1e-7);
    for (std::size_t f = 0; f < errors.size(); ++f) {
      if (0.02 * static_cast<double>(f) >= ran.summary.predictable_until_s.value_or(1.0)) break;
      EXPECT_LE(errors[f], 10.0 * tolerance) << "in frame " << f;
    }
  }
}

TEST(AccurateSteps, EndWhereAScriptTurns) {
  Scene scene = hanging_yarn();
  scene.handles[0].motion = {{0.0123456, Vec3(0.01, 0.0, 0.0)}, {0.03, Vec3(0.0, 0.01, 0.0)}};
  scene.duration_s = 0.05;
  scene.frames_per_s = 20.0;
  const Ran ran = run_to(scene, 1e-4);
  for (const double corner : {0.0123456, 0.03, 0.05}) {
    EXPECT_TRUE(std::any_of(ran.times.begin(), ran.times.end(), [&](double t) { return std::abs(t - corner) < 1e-9; }))
        << "no step ended at " << corner << " s";
  }
}

/// Two stiff links, dropped from above: the double pendulum.
Scene double_pendulum() {
  Scene scene = hanging_yarn();
  scene.yarns[0].points = {Vec3::Zero(), Vec3(0.0, 0.1, 0.0), Vec3(0.02, 0.195, 0.01)};
  scene.effects.bending.reset();
  scene.yarn.stretch_n = 500.0;
  scene.effects.damping = DampingEffect{0.05, 0.0, 0.0, 0.0};
  scene.duration_s = 4.0;
  scene.frames_per_s = 20.0;
  return scene;
}

TEST(AccurateSteps, SayFromWhereOnTheMotionCannotBeTold) {
  Scene scene = double_pendulum();
  const Ran ran = run_to(scene, 1e-4);
  ASSERT_TRUE(ran.summary.predictable_until_s.has_value());
  const double until = *ran.summary.predictable_until_s;
  EXPECT_GT(until, 0.15);
  EXPECT_LT(until, scene.duration_s);
  scene.duration_s = 0.15;
  EXPECT_FALSE(run_to(scene, 1e-4).summary.predictable_until_s.has_value());
}

TEST(AccurateSteps, KeepStaticScenesOnTheirPath) {
  Scene scene = hanging_yarn();
  scene.effects.inertia.reset();
  scene.handles.push_back(held(0, -1));
  scene.handles[1].velocity_m_per_s = Vec3(-0.2, 0.0, 0.0);
  scene.effects.damping = DampingEffect{1e-3, 1e-5, 0.0, 0.0};
  scene.duration_s = 0.2;
  scene.frames_per_s = 10.0;
  const Ran exact = run_exactly(scene, 0.2 / 512);
  for (const double tolerance : {1e-3, 1e-4}) {
    const Ran ran = run_to(scene, tolerance);
    const double error = largest(distances(ran, exact, 5)), estimate = ran.summary.error_estimate_m.value_or(0.0);
    std::printf("tolerance %.0e m: error %.2e, estimated %.2e, %ld steps\n", tolerance, error, estimate,
                ran.summary.steps);
    EXPECT_LE(error, tolerance);
    EXPECT_LE(error, 3.0 * estimate);
  }
}

}  // namespace
}  // namespace slipstitch::testing
