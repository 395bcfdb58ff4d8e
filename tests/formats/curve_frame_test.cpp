// SPDX-License-Identifier: MIT
#include "formats/curve_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/sample_run.h"

namespace slipstitch::test {
namespace {

TEST(CurveFrame, HoldsOnePointAVisitInYarnOrder) {
  const FrameHeader header = sample_header();
  const Frame start = sample_frame(header, 0), frame = sample_frame(header, 2);
  const CurveFrame curves = make_curve_frame(header, frame, start);
  EXPECT_EQ(curves.index, 2);
  EXPECT_EQ(curves.t, frame.t);
  EXPECT_EQ(curves.radius_m, 0.6e-3);
  EXPECT_EQ(curves.first, (std::vector<int>{0, 4, 7}));
  ASSERT_EQ(curves.points.size(), 7u);
  const std::vector<int> nodes{0, 1, 2, 3, 4, 2, 1};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    EXPECT_EQ(curves.points[i], Vec3(frame.q.segment<3>(3 * nodes[i])));
    EXPECT_EQ(curves.arc_length_m[i], frame.q[18 + static_cast<int>(i)]);
    EXPECT_EQ(curves.slid_m[i], frame.q[18 + static_cast<int>(i)] - start.q[18 + static_cast<int>(i)]);
  }
}

TEST(CurveFrame, TensionOfAPointIsTheMeanOfItsSegments) {
  const FrameHeader header = sample_header();
  const Frame frame = sample_frame(header, 1);
  const std::vector<double> tension = derive(header, frame, frame).tension_n;
  const std::vector<double> expected{tension[0],
                                     (tension[0] + tension[1]) / 2,
                                     (tension[1] + tension[2]) / 2,
                                     tension[2],
                                     tension[4],
                                     (tension[4] + tension[5]) / 2,
                                     tension[5]};
  EXPECT_EQ(make_curve_frame(header, frame, frame).tension_n, expected);
}

TEST(CurveFrame, WrapAnglesComeInPairs) {
  const FrameHeader header = sample_header();
  const Frame frame = sample_frame(header, 1);
  const std::vector<double> wrap = derive(header, frame, frame).wrap_rad;
  const CurveFrame curves = make_curve_frame(header, frame, frame);
  ASSERT_EQ(wrap.size(), 2u);
  ASSERT_EQ(curves.wrap_rad.size(), 1u);
  EXPECT_TRUE(std::isnan(curves.wrap_rad[0][0]));  // no outer node q3 there
  EXPECT_TRUE(std::isfinite(wrap[1]));
  EXPECT_EQ(curves.wrap_rad[0][1], wrap[1]);
}

}  // namespace
}  // namespace slipstitch::test
