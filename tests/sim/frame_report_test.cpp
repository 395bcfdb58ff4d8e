// SPDX-License-Identifier: MIT
#include "sim/frame_report.h"

#include "sim/run.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

// A swatch that falls on a sphere: collisions come and go.
Scene falling_swatch() {
  Scene scene = free_swatch(4, 4);
  scene.effects.gravity.emplace();
  scene.effects.self_collision.emplace();
  scene.effects.colliders.emplace().colliders = {{Sphere{Vec3(0.005, -0.006, 0.0), 0.005}, 0.3, {}}};
  scene.frames_per_s = 200.0;
  scene.duration_s = 0.02;
  return scene;
}

struct ReportedRun {
  std::vector<FrameReport> reports;
  std::vector<Frame> frames;
  RunSummary summary;
};

ReportedRun reported(const Scene& scene, bool with_reports) {
  ReportedRun result;
  RunHooks hooks;
  hooks.on_frame = [&](const Frame& frame) { result.frames.push_back(frame); };
  if (with_reports) hooks.on_frame_report = [&](const FrameReport& report) { result.reports.push_back(report); };
  result.summary = run(scene, 1, hooks);
  EXPECT_EQ(result.summary.status, RunStatus::succeeded) << result.summary.message;
  return result;
}

TEST(FrameReport, ComesWithEveryFrameAndEndsAsTheSummary) {
  const ReportedRun run = reported(falling_swatch(), true);
  ASSERT_EQ(run.reports.size(), run.frames.size());
  for (std::size_t i = 0; i < run.reports.size(); ++i) {
    EXPECT_EQ(run.reports[i].frame, run.frames[i].index);
    EXPECT_EQ(run.reports[i].t, run.frames[i].t);
    EXPECT_EQ(run.reports[i].energy_j.size(), run.reports[0].energy_j.size()) << "the same columns at every frame";
    EXPECT_EQ(run.reports[i].step_s.has_value(), i > 0);
  }
  EXPECT_FALSE(run.reports.front().energy_j.at("colliders"));
  const FrameReport& last = run.reports.back();
  EXPECT_TRUE(last.energy_j.at("colliders")) << "the swatch has come down";
  EXPECT_EQ(last.steps, run.summary.steps);
  EXPECT_EQ(last.rejected_steps, run.summary.rejected_steps);
  EXPECT_EQ(last.newton_iterations, run.summary.newton_iterations);
  EXPECT_EQ(last.linear_iterations, run.summary.linear_iterations);
  EXPECT_GT(*last.step_s, 0.0);
  for (const auto& [term, energy] : run.summary.energy_j) {
    ASSERT_TRUE(last.energy_j.contains(term)) << term;
    EXPECT_NEAR(last.energy_j.at(term).value_or(0.0), energy, 1e-12 * (1.0 + std::abs(energy))) << term;
  }
}

// Not a bit of the run, not a count of what it took.
TEST(FrameReport, ChangesNothing) {
  const ReportedRun with = reported(falling_swatch(), true), without = reported(falling_swatch(), false);
  ASSERT_EQ(with.frames.size(), without.frames.size());
  for (std::size_t i = 0; i < with.frames.size(); ++i) EXPECT_EQ(with.frames[i].q, without.frames[i].q) << i;
  EXPECT_EQ(with.summary.state_hash, without.summary.state_hash);
  EXPECT_EQ(with.summary.factorizations, without.summary.factorizations);
  for (const auto& [effect, cost] : without.summary.effect_cost) {
    EXPECT_EQ(with.summary.effect_cost.at(effect).evaluations, cost.evaluations) << effect;
    EXPECT_EQ(with.summary.effect_cost.at(effect).searches, cost.searches) << effect;
  }
}

}  // namespace
}  // namespace slipstitch::testing
