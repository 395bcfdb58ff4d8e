// SPDX-License-Identifier: MIT
#include "sim/run.h"

#include <algorithm>

#include "force/stretch.h"
#include "sim/monitor.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

Scene short_run() {
  Scene scene = hanging_yarn();
  scene.duration_s = 0.1;
  scene.frames_per_s = 40.0;
  scene.numerics = FixedNumerics{.time_step_s = 1.0 / 100};
  return scene;
}

TEST(Run, FillsTheSummary) {
  const RunSummary summary = run(short_run(), 3, {});
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  EXPECT_EQ(summary.scene, "hanging yarn");
  EXPECT_EQ(summary.loops, 0);
  EXPECT_EQ(summary.nodes, 5);
  EXPECT_EQ(summary.dofs, 12);
  EXPECT_EQ(summary.effects, (std::vector<std::string>{"inertia", "gravity", "stretch", "bending"}));
  EXPECT_NEAR(summary.sim_time_s, 0.1, 1e-12);
  EXPECT_GT(summary.wall_s, 0.0);
  EXPECT_EQ(summary.frames, 5);
  EXPECT_EQ(summary.steps, 12);  // three a frame, so that frames fall on steps
  EXPECT_EQ(summary.rejected_steps, 0);
  EXPECT_GE(summary.newton_iterations, summary.steps);
  EXPECT_GE(summary.factorizations, summary.steps);  // the last iterations of a step share a factor
  EXPECT_GE(summary.linear_iterations, summary.newton_iterations);
  EXPECT_GT(summary.residual, 0.0);
  EXPECT_LE(summary.residual, 1e-4);
  EXPECT_EQ(summary.residual_unit, "m/s");
  EXPECT_EQ(summary.energy_j.size(), 4U);
  EXPECT_TRUE(summary.wall_by_phase_s.contains("factor"));
  EXPECT_TRUE(summary.max_stretch.has_value());
  EXPECT_NEAR(summary.min_arc_gap_ratio.value_or(0.0), 1.0, 1e-12);
  EXPECT_EQ(summary.crushed_entries, 0);
  EXPECT_EQ(summary.state_hash.size(), 16U);
  EXPECT_EQ(summary.threads, 3);
  EXPECT_FALSE(summary.linear_solver.empty());
  // not measured in this scene
  EXPECT_FALSE(summary.max_slid_m.has_value());
  EXPECT_FALSE(summary.faded_wrap_share.has_value());
  EXPECT_FALSE(summary.error_estimate_m.has_value());
}

TEST(Run, PressesYarnToNoPointAndCountsWhereItComesNear) {
  Scene scene = short_run();
  scene.effects.gravity.reset();
  scene.handles = {held(0, 0), held(0, 2)};
  scene.initial_velocities = {{YarnPoint{0, 1}, {-100.0, 0.0, 0.0}}};  // twenty times what the next piece can store
  scene.duration_s = 2e-3;  // there and back
  scene.frames_per_s = 500.0;
  scene.numerics = FixedNumerics{.time_step_s = 1e-4};
  RunHooks hooks;
  double least = 1.0;
  hooks.on_step = [&](const Simulation& sim, const StepReport&) { least = std::min(least, sim.state().q[3]); };
  const RunSummary summary = run(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  EXPECT_EQ(summary.rejected_steps, 0);
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, kCrushed * 0.05);
  EXPECT_EQ(summary.crushed_entries, 1);
}

TEST(Run, TracesDynamicSpheres) {
  Scene scene = short_run();
  scene.effects.colliders.emplace().colliders = {
      {Plane{Vec3(0.0, -1.0, 0.0), Vec3::UnitY()}, 0.3, {}},
      {Sphere{Vec3(0.0, 0.5, 0.0), 0.01}, 0.3, {}, DynamicBody{0.1, Vec3(2.0, 0.0, 0.0)}}};
  std::vector<double> times;
  std::vector<Vec3> centres;
  VecX last;
  RunHooks hooks;
  hooks.on_header = [](const FrameHeader& header) { EXPECT_EQ(header.topology.num_bodies, 1); };
  hooks.on_frame = [&](const Frame& frame) { last = frame.q; };
  hooks.on_bodies = [&](double t, const std::vector<Vec3>& all) {
    ASSERT_EQ(all.size(), 1U);
    times.push_back(t);
    centres.push_back(all[0]);
  };
  const RunSummary summary = run(scene, 1, hooks);
  ASSERT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  ASSERT_EQ(static_cast<long>(times.size()), summary.steps + 1);
  EXPECT_EQ(times[0], 0.0);
  EXPECT_EQ(centres[0], Vec3(0.0, 0.5, 0.0));
  EXPECT_NEAR(times.back(), 0.1, 1e-12);
  ASSERT_EQ(summary.bodies.size(), 1U);
  EXPECT_EQ(summary.bodies[0].collider, 1);
  EXPECT_EQ(summary.bodies[0].position_m, centres.back());
  EXPECT_EQ(Vec3(last.segment<3>(3 * 5)), centres.back());
  EXPECT_NEAR(centres.back().x(), 0.2, 1e-9);
  EXPECT_NEAR(summary.bodies[0].velocity_m_per_s.x(), 2.0, 1e-9);
  EXPECT_NEAR(summary.bodies[0].velocity_m_per_s.y(), -9.81 * 0.1, 1e-9);
}

TEST(Run, TakesAStepWrittenToSixDigitsForTheOneMeant) {
  Scene scene = short_run();
  scene.frames_per_s = 30.0;
  scene.numerics = FixedNumerics{.time_step_s = 0.00833333};  // 1/120
  EXPECT_EQ(run(scene, 1, {}).steps, 12);                     // four a frame, three frames
}

TEST(Run, TellsThePlannedTimesOfFramesAndTheEnd) {
  Scene scene = short_run();
  scene.duration_s = 0.3;
  scene.frames_per_s = 30.0;
  scene.numerics = AccuracyNumerics{.tolerance_m = 1e-4};
  std::vector<double> frames, reports;
  double told = 0.0;
  RunHooks hooks;
  hooks.on_frame = [&](const Frame& frame) { frames.push_back(frame.t); };
  hooks.on_frame_report = [&](const FrameReport& report) { reports.push_back(report.t); };
  hooks.on_progress = [&](const Progress& progress) { told = progress.t; };
  const RunSummary summary = run(scene, 1, hooks);
  std::vector<double> planned;
  for (int frame = 0; frame < 10; ++frame) planned.push_back(std::min(frame / 30.0, 0.3));
  EXPECT_EQ(frames, planned);
  EXPECT_EQ(reports, planned);
  EXPECT_EQ(told, 0.3);
  EXPECT_EQ(summary.sim_time_s, 0.3);
}

TEST(Run, MeasuresNothingWithoutAStep) {
  Scene scene = crossed_yarns();
  scene.duration_s = 0.0;
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.steps, 0);
  EXPECT_TRUE(std::isnan(summary.residual));
  EXPECT_FALSE(summary.max_slid_m.has_value());
  EXPECT_FALSE(summary.max_stretch.has_value());
}

TEST(Run, GivesTheHeaderOnceAndFramesInOrder) {
  int headers = 0;
  std::vector<Frame> frames;
  RunHooks hooks;
  hooks.on_header = [&](const FrameHeader& header) {
    ++headers;
    EXPECT_TRUE(frames.empty());
    EXPECT_EQ(header.num_frames, 5);
    EXPECT_EQ(header.topology.num_nodes, 5);
    EXPECT_EQ(header.frames_per_s, 40.0);
  };
  hooks.on_frame = [&](const Frame& frame) { frames.push_back(frame); };
  run(short_run(), 1, hooks);
  EXPECT_EQ(headers, 1);
  ASSERT_EQ(frames.size(), 5U);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].index, static_cast<int>(k));
    EXPECT_NEAR(frames[k].t, static_cast<double>(k) / 40.0, 1e-12);
  }
  EXPECT_EQ(frames[0].q, compile(short_run(), nullptr).start_q);
  EXPECT_LT(frames[4].q[13], frames[3].q[13]);  // the free end falls
}

TEST(Run, StopsWhenAsked) {
  RunHooks hooks;
  int frames = 0;
  hooks.on_frame = [&](const Frame&) { ++frames; };
  hooks.should_stop = [&] { return frames >= 2; };
  const RunSummary summary = run(short_run(), 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::cancelled);
  EXPECT_EQ(summary.frames, 2);
  EXPECT_LT(summary.sim_time_s, 0.05);
}

TEST(Run, FailsWithAReasonWhenNoStepConverges) {
  Scene scene = short_run();
  auto& numerics = std::get<FixedNumerics>(scene.numerics);
  numerics.max_newton_iterations = 1;
  numerics.velocity_tolerance_m_per_s = 1e-15;
  numerics.smallest_step_s = 1e-3;
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_GT(summary.rejected_steps, 0);
  EXPECT_EQ(summary.steps, 0);
  EXPECT_EQ(summary.frames, 1);
  EXPECT_NE(summary.message.find("too many Newton iterations"), std::string::npos) << summary.message;
}

TEST(Run, MeasuresSlidingAndReportsNewtonsWhenQuasiStatic) {
  Scene scene = crossed_yarns();
  scene.effects.inertia.reset();
  scene.handles = {held(1, 0), held(1, -1), held(0, 0), held(0, -1)};
  scene.handles.back().motion = {{0.1, {0.02, 0.0, 0.0}, Vec3::Zero()}};
  scene.duration_s = 0.1;
  scene.numerics = FixedNumerics{.force_tolerance_n = 1e-9, .max_newton_iterations = 300};
  const RunSummary summary = run(scene, 1, {});
  ASSERT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  EXPECT_EQ(summary.residual_unit, "N");
  EXPECT_LE(summary.residual, 1e-9);
  EXPECT_GT(summary.max_slid_m.value_or(0.0), 1e-4);
  EXPECT_LE(summary.mean_slid_m.value_or(1.0), summary.max_slid_m.value_or(0.0));
}

TEST(Run, PlansTheFramesThatFitIntoTheDuration) {
  EXPECT_EQ(planned_frames(2.0, 30.0), 61);
  EXPECT_EQ(planned_frames(0.0, 30.0), 1);
  EXPECT_EQ(planned_frames(0.1, 30.0), 4);
  EXPECT_EQ(planned_frames(0.0999, 30.0), 4);
  EXPECT_EQ(planned_frames(0.02, 30.0), 2);
}

TEST(Run, PlansItsStepsUpToTheLastFrame) {
  EXPECT_EQ(least_steps(2.0, 30.0, 1.0 / 240.0), 480);
  EXPECT_EQ(least_steps(0.0, 30.0, 1.0 / 240.0), 0);
  Scene scene = short_run();
  for (double duration : {0.02, 0.05, 0.0651}) {
    scene.duration_s = duration;
    std::get<FixedNumerics>(scene.numerics).time_step_s = 4e-3;
    const RunSummary summary = run(scene, 1, {});
    EXPECT_NEAR(summary.sim_time_s, duration, 1e-12);
    EXPECT_EQ(summary.steps, least_steps(duration, scene.frames_per_s, 4e-3)) << duration;
  }
}

Scene twisted_swatch() {
  Scene scene = test::knit_scene("stockinette", 8, 6);
  const Keyframe turned{0.3, Vec3::Zero(), Vec3(0.0, 6.28, 0.0)};
  scene.handles = {{Edge::bottom, {}, false}, {Edge::top, {Keyframe{}, turned}, false}};
  scene.duration_s = 1.0 / 60.0;
  scene.frames_per_s = 60.0;
  scene.numerics = FixedNumerics{.time_step_s = 1.0 / 120.0};
  return scene;
}

TEST(Run, TwistsASwatchWithoutTearingItsYarn) {
  const RunSummary summary = run(twisted_swatch(), 1, {});
  EXPECT_GT(summary.min_arc_gap_ratio.value_or(0.0), 1e-3);
  EXPECT_LT(summary.max_stretch.value_or(1e9), 1.5);
  EXPECT_LT(summary.energy_j.at("stretch"), 1e-2);
}

TEST(Run, CanBeCancelledWhileTheRepeatIsRelaxed) {
  RunHooks hooks;
  int polls = 0;
  bool begun = false;
  hooks.should_stop = [&] { return ++polls > 3; };
  hooks.on_header = [&](const FrameHeader&) { begun = true; };
  EXPECT_EQ(run(twisted_swatch(), 1, hooks).status, RunStatus::cancelled);
  EXPECT_EQ(polls, 4);
  EXPECT_FALSE(begun);
}

TEST(Run, StopsWhereAYarnEndReachesAGuide) {
  Scene scene = hanging_yarn();  // over a guide at its second point, and heavier beyond
  scene.handles.clear();
  scene.guides = {{0, 1}};
  scene.effects.sliding.emplace();
  scene.duration_s = 1.0;
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_NE(summary.message.find("point 1 of yarn 0"), std::string::npos) << summary.message;
  EXPECT_LT(summary.sim_time_s, 1.0);
}

TEST(Run, StopsWhereTheKnitsYarnIsPulledOutOfAStitch) {
  Scene scene = test::knit_scene("stockinette", 4, 4);
  test::use_demo_feel(scene.effects);
  scene.effects.sliding_friction.reset();
  const Vec3 out(0.0, 0.02, 0.0);  // [m] two stitches' yarn, drawn from the last tail
  scene.handles = {Handle{StitchRange{1, 2, 1, 4}, {}, false}, Handle{YarnPoint{0, -6}, {{0.0}, {0.5, out}}, false}};
  scene.duration_s = 0.5;
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_NE(summary.message.find("the contact at course 4, wale 4"), std::string::npos) << summary.message;
}

TEST(Run, StaysAtRestOnceItIsThere) {
  Scene scene = hanging_yarn();
  scene.handles.clear();
  scene.effects.gravity.reset();
  scene.yarns[0].prestretch = 1.1;
  scene.effects.damping.emplace().stretch_ns = 1e-2;
  scene.duration_s = 0.2;
  scene.frames_per_s = 10.0;
  scene.numerics = FixedNumerics{.time_step_s = 1e-3};
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  EXPECT_EQ(summary.rejected_steps, 0);
  EXPECT_LE(summary.newton_iterations, 3 * summary.steps);
}

// A pin that jumps a metre in a millisecond, in steps that cannot be that short.
TEST(Run, ThatFailsNamesThePlaceTheEffectAndTheTimeAndKeepsTheLastGoodState) {
  Scene scene = short_run();
  scene.handles[0].motion = {{0.06, Vec3::Zero(), Vec3::Zero()}, {0.061, Vec3(0.0, 1.0, 0.0), Vec3::Zero()}};
  auto& numerics = std::get<FixedNumerics>(scene.numerics);
  numerics.max_newton_iterations = 8;
  numerics.smallest_step_s = 5e-3;
  std::vector<Frame> frames;
  RunHooks hooks;
  hooks.on_frame = [&](const Frame& frame) { frames.push_back(frame); };
  const RunSummary summary = run(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::failed);
  EXPECT_NE(summary.message.find("at t = 0.0666667 s"), std::string::npos) << summary.message;
  EXPECT_NE(summary.message.find("worst at point "), std::string::npos) << summary.message;
  EXPECT_NE(summary.message.find("where the largest force is that of stretch"), std::string::npos) << summary.message;
  ASSERT_EQ(frames.size(), 4U);  // at 0, 0.025, 0.05 s, and the last good state
  EXPECT_EQ(summary.frames, 4);
  EXPECT_EQ(frames.back().index, 3);
  EXPECT_EQ(frames.back().t, summary.sim_time_s);
  EXPECT_EQ(state_hash(frames.back().q), summary.state_hash);
  EXPECT_GT(frames.back().t, 0.055);
}

}  // namespace
}  // namespace slipstitch::testing
