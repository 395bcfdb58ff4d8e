// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "sim/run.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

// The demo's swatch with a quarter of its courses and wales.
Scene drape(double step_s) {
  Scene scene = test::knit_scene("stockinette", 10, 10);
  scene.knit->placement.wale_direction = Vec3(0.0, 0.0, -1.0);
  scene.effects.gravity.emplace();
  test::use_demo_feel(scene.effects);
  for (Corner corner : {Corner::top_left, Corner::top_right}) scene.handles.push_back(Handle{corner, {}, false});
  scene.duration_s = 0.5;
  scene.frames_per_s = 30.0;
  scene.numerics = FixedNumerics{.time_step_s = step_s};
  return scene;
}

struct Ended {
  RunSummary summary;
  VecX start, end;  // positions
};

Ended run_to_end(const Scene& scene) {
  EXPECT_TRUE(check(scene).empty());
  Ended ended;
  int position_coords = 0;
  RunHooks hooks;
  hooks.on_header = [&](const FrameHeader& header) { position_coords = 3 * header.topology.num_nodes; };
  hooks.on_frame = [&](const Frame& frame) { (frame.index == 0 ? ended.start : ended.end) = frame.q.head(position_coords); };
  ended.summary = run(scene, 1, hooks);
  EXPECT_EQ(ended.summary.status, RunStatus::succeeded) << ended.summary.message;
  return ended;
}

double farthest(const VecX& a, const VecX& b) {
  double farthest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); i += 3) farthest = std::max(farthest, (a - b).segment<3>(i).norm());
  return farthest;
}

TEST(Drape, FallsAndEndsWhereItDoesWithHalfTheStep) {
  const Scene scene = drape(1.0 / 120.0);
  const Ended whole = run_to_end(scene), half = run_to_end(drape(1.0 / 240.0));
  const double apart = farthest(whole.end, half.end);
  std::printf("%ld Newton iterations in %ld steps; end positions %.3f mm apart; lowest point %.1f mm\n",
              whole.summary.newton_iterations, whole.summary.steps, 1e3 * apart,
              1e3 * Eigen::Map<const Eigen::Matrix3Xd>(whole.end.data(), 3, whole.end.size() / 3).row(1).minCoeff());
  EXPECT_LE(apart, 5.0 * scene.yarn.radius_m);
  EXPECT_GT(farthest(whole.end, whole.start), 5e-3);
  for (const Ended* run : {&whole, &half}) {
    EXPECT_LE(run->summary.residual, 1e-4);
    EXPECT_EQ(run->summary.rejected_steps, 0);
    EXPECT_GT(run->summary.max_slid_m.value_or(0.0), 1e-4);
  }
  // What the demo costs, as a count: it took 29 iterations a step where tails and stale tensions held it up.
  EXPECT_LE(whole.summary.newton_iterations, 10 * whole.summary.steps);
}

}  // namespace
}  // namespace slipstitch
