// SPDX-License-Identifier: MIT
#include "model/drawn_loop.h"

#include <gtest/gtest.h>

#include "knit_helpers.h"

namespace slipstitch {
namespace {

constexpr double kWidth = 2.9e-3, kHeight = 2.03e-3, kRadius = 0.524e-3;

DrawnLoop demo_loop() { return draw_loop(kWidth, kHeight, kRadius); }
LoopFaces faces(double sign) { return {sign, sign, sign, sign}; }

// The loop of the course above, in the frame of the loop below.
Vec3 above(const DrawnLoop& loop, double sign, double t) {
  return centreline(loop, faces(sign), t) + loop.height_m * Vec3::UnitY();
}

TEST(DrawnLoop, TakesTheYarnOfTheMeasuredStitch) {
  const double length = centreline_length(demo_loop(), faces(1.0));
  EXPECT_NEAR(length, 11.28e-3, 0.001e-3);
  const double polyline_share = drawn_cell(test::stockinette(2, 2).pattern, Gauge{}, YarnMaterial{}).density_scale;
  EXPECT_NEAR(1.0 / polyline_share, 0.840, 0.001);
}

TEST(DrawnLoop, YarnsCrossTwoRadiiApartBetweenTheNodes) {
  const DrawnLoop loop = demo_loop();
  for (const double sign : {1.0, -1.0}) {
    const Vec3 o1 = centreline(loop, faces(sign), -loop.leg_t), n1 = above(loop, sign, -kPi + loop.sinker_t);
    const Vec3 o2 = centreline(loop, faces(sign), -loop.sinker_t), n2 = above(loop, sign, -kPi + loop.leg_t);
    EXPECT_NEAR((o1 - n1).head<2>().norm(), 0.0, 1e-12);
    EXPECT_NEAR((o2 - n2).head<2>().norm(), 0.0, 1e-12);
    // Knit: the new loop passes behind the old one at P1 and in front of it at P2.
    EXPECT_NEAR(n1.z() - o1.z(), -sign * 2.0 * kRadius, 1e-12);
    EXPECT_NEAR(n2.z() - o2.z(), +sign * 2.0 * kRadius, 1e-12);
    // The crossings lie within the zone that the nodes end.
    EXPECT_LT(-o1.x(), loop.p1_x);
    EXPECT_GT(-o2.x(), loop.p2_x);
    EXPECT_LT(o2.y() - o1.y(), loop.p2_y);
    EXPECT_NEAR(0.5 * (o1.z() + n1.z()), sign * loop.z, 1e-12);
    EXPECT_NEAR(0.5 * (o2.z() + n2.z()), sign * loop.z, 1e-12);
  }
}

// Outer points in the middle of the free yarn, where the curve bulges: +-pi/2 or so, the same on both diagonals.
TEST(DrawnLoop, WrapsHaveTheSignOfKindAndSide) {
  const DrawnLoop loop = demo_loop();
  for (const double sign : {1.0, -1.0}) {
    for (const double side : {1.0, -1.0}) {  // +1: left clasp, t < 0
      const auto mirrored = [&](Vec3 x) { return Vec3(side * x.x(), x.y(), x.z()); };
      const auto mean = [&](double old_t, double new_t) {
        return mirrored(0.5 * (centreline(loop, faces(sign), old_t) + above(loop, sign, new_t)));
      };
      const Vec3 q0 = mean(-loop.leg_t, -kPi + loop.sinker_t), q1 = mean(-loop.sinker_t, -kPi + loop.leg_t);
      const Vec3 q4 = mirrored(above(loop, sign, -kPi)), q5 = mirrored(above(loop, sign, -kPi / 2));
      const Vec3 q2 = mirrored(centreline(loop, faces(sign), -kPi / 2));
      const Vec3 q3 = mirrored(centreline(loop, faces(sign), 0.0));
      const double first = test::wrap_angle(q0, q1, q3, q4), second = test::wrap_angle(q1, q0, q2, q5);
      EXPECT_GT(sign * side * first, 0.5);
      EXPECT_GT(sign * side * second, 0.5);
      EXPECT_LT(sign * side * first, 2.5);
      EXPECT_LT(sign * side * second, 2.5);
    }
  }
}

TEST(DrawnLoop, ContactsAndWrapTrianglesAreHealthy) {
  const DrawnLoop loop = demo_loop();
  const double dx = loop.p1_x - loop.p2_x, dy = loop.p2_y;
  const double contact = std::hypot(dx, dy);
  EXPECT_NEAR(contact, 1.422e-3, 0.001e-3);
  const double leg = std::hypot(dx, kHeight - dy);
  EXPECT_GT(dx * kHeight / (contact * leg), 0.3) << "sine between axis and leg";
  EXPECT_GT(dy / contact, 0.3) << "sine between axis and sinker or head";
}

}  // namespace
}  // namespace slipstitch
