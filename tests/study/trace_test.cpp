// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/prepare.h"
#include "study/compare_rungs.h"
#include "study/measured_run.h"
#include "study/start_noise.h"
#include "study/study_scenes.h"
#include "study/trace_difference.h"

namespace slipstitch::testing {
namespace {

FrameTrace trace_of(const std::vector<VecX>& x) {
  FrameTrace trace;
  for (const VecX& frame : x) {
    trace.t.push_back(0.1 * static_cast<double>(trace.x.size()));
    trace.x.push_back(frame);
    trace.stored_j.push_back(1.0);
    trace.force_n.push_back(2.0);
    trace.length_m.push_back(3.0);
  }
  return trace;
}

TEST(Trace, HasWhatARunShows) {
  Scene scene = smooth_swing();
  scene.duration_s = 0.3;
  FrameTrace trace;
  MeasureOptions options;
  options.trace = &trace;
  const MeasuredRun run = measure_run(scene, options);
  ASSERT_EQ(trace.size(), 10U);
  EXPECT_EQ(trace.x[0].size(), 15);
  EXPECT_NEAR(trace.t.back(), 0.3, 1e-12);
  EXPECT_NEAR(trace.length_m[0], 0.2, 1e-12);
  EXPECT_GT(trace.length_m.back(), 0.2);                    // it hangs from its end
  EXPECT_NEAR(trace.stored_j.back(), run.stored_j, 1e-12);  // the same by another way
  EXPECT_EQ(trace.force_n[0], 0.0);
  EXPECT_NEAR(trace.force_n.back(), run.summary.handles[0].reaction_n.norm(), 1e-12);
  EXPECT_LT(trace.force_n.back(), 0.9 * run.summary.handles[0].max_reaction_n);  // now, not the largest so far
  scene.handles.clear();
  scene.initial_velocities = {{YarnPoint{0, 4}, {1.0, 0.0, 0.0}}};
  trace = {};
  measure_run(scene, options);
  double most = 0.0;
  for (std::size_t k = 0; k < trace.size(); ++k) {
    double tension = 0.0;  // the largest
    for (int i = 0; i < 4; ++i) {
      const Vec3 d = trace.x[k].segment<3>(3 * i + 3) - trace.x[k].segment<3>(3 * i);
      tension = std::max(tension, scene.yarn.stretch_n * (d.norm() / 0.05 - 1.0));
    }
    EXPECT_NEAR(trace.force_n[k], tension, 1e-9) << k;
    most = std::max(most, tension);
  }
  EXPECT_GT(most, 1e-5);
}

TEST(Trace, DifferencesAreTakenFrameByFrame) {
  const VecX zero = VecX::Zero(60);  // 20 nodes
  VecX moved = zero;
  moved.segment<3>(9) = Vec3(3.0, 0.0, 4.0);
  moved[6] = 1.0;
  FrameTrace b = trace_of({zero, zero, zero});
  b.stored_j[1] = 1.5;
  b.force_n[2] = 0.0;
  b.length_m[2] = 3.25;
  const TraceDifference d = difference(trace_of({zero, moved, zero}), b);
  EXPECT_EQ(d.max_m, (std::vector<double>{0.0, 5.0, 0.0}));
  EXPECT_EQ(d.most_m, (std::vector<double>{0.0, 1.0, 0.0}));  // all but one of twenty
  EXPECT_EQ(d.node[1], 3);
  EXPECT_NEAR(d.mean_m2[1], 26.0 / 20.0, 1e-12);
  EXPECT_EQ(d.stored_j, 0.5);
  EXPECT_EQ(d.force_n, 2.0);
  EXPECT_EQ(d.length_m, 0.25);
  EXPECT_EQ(largest(d.max_m, 1), 0.0);
  EXPECT_EQ(largest(d.max_m, 2), 5.0);
  EXPECT_EQ(place_of_largest(d.max_m, 3), 1U);
  EXPECT_NEAR(root_mean(d.mean_m2, 2), std::sqrt(1.3 / 2.0), 1e-12);
}

TEST(Trace, WhatIsNotFiniteIsInfinitelyFar) {
  VecX wild = VecX::Zero(6);
  wild[0] = std::nan("");
  FrameTrace a = trace_of({VecX::Zero(6), wild});
  a.stored_j[1] = std::nan("");
  const TraceDifference d = difference(a, trace_of({VecX::Zero(6), VecX::Zero(6)}));
  EXPECT_TRUE(std::isinf(d.max_m[1]));
  EXPECT_TRUE(std::isinf(d.stored_j));
}

TEST(Trace, PredictableFramesEndWhereNoiseReachesAThirdOfTheError) {
  const std::vector<double> error{0.0, 1e-4, 3e-4, 9e-4};
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-8, 1e-7, 2e-4}, 1e-6), 4U);
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-8, 1e-7, 4e-4}, 1e-6), 3U);
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-8, 2e-4, 4e-4}, 1e-6), 2U);  // 3e-4 is no error of the first three
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-4, 2e-4, 4e-4}, 1e-6), 1U);
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-4, 2e-4, 4e-4}, 1e-2), 4U);
  EXPECT_EQ(predictable_frames(error, {1e-9, 1e-8}, 1e-6), 2U);
}

TEST(Trace, HalfOfTheRungsDrawTheCommonHorizon) {
  const auto with_errors = [](double last) {
    TraceDifference d;
    d.max_m = {0.0, 0.1 * last, last};
    return std::optional<TraceDifference>(d);
  };
  const std::vector<double> parting{1e-9, 1e-9, 1e-4};
  const RungDifferences rungs{with_errors(1e-2), with_errors(1e-3), with_errors(1e-5), std::nullopt};
  const Horizon two_of_three = common_horizon(rungs, parting, 1e-6);
  EXPECT_EQ(two_of_three.frames, 3U);
  EXPECT_EQ(two_of_three.own, (std::vector<std::size_t>{3, 3, 2, 0}));
  EXPECT_EQ(*smallest_error(rungs, two_of_three), 1e-3);  // the third is less than what noise does
  const RungDifferences finer{with_errors(1e-2), with_errors(1e-5), with_errors(1e-5)};
  EXPECT_EQ(common_horizon(finer, parting, 1e-6).frames, 2U);
  EXPECT_EQ(common_horizon(finer, {}, 1e-6).frames, 3U);
  EXPECT_FALSE(smallest_error({std::nullopt}, common_horizon({std::nullopt}, parting, 1e-6)));
}

TEST(StartNoise, MovesWhatIsFreeAndIsAlwaysTheSame) {
  const Model plain = prepare(crossed_yarns()).model;
  Model noisy = plain, again = plain;
  add_start_noise(noisy, 1e-9);
  add_start_noise(again, 1e-9);
  EXPECT_EQ(noisy.start_q, again.start_q);
  const VecX moved = noisy.start_q - plain.start_q;
  const int coords = 3 * plain.topology.num_nodes;
  EXPECT_EQ(moved.head<3>(), Vec3::Zero());  // held
  for (int c = 3; c < coords; ++c) EXPECT_NE(moved[c], 0.0) << c;
  EXPECT_LE(moved.cwiseAbs().maxCoeff(), 1.01e-9);
  EXPECT_GT(moved.cwiseAbs().maxCoeff(), 5e-10);
  EXPECT_EQ(moved.tail(moved.size() - coords).cwiseAbs().maxCoeff(), 0.0);  // arc lengths
}

}  // namespace
}  // namespace slipstitch::testing
