// SPDX-License-Identifier: MIT
#include "collide/closest_point.h"

#include <gtest/gtest.h>

#include <random>

namespace slipstitch {
namespace {

Vec3 random_point(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

TEST(ClosestPoint, OfTwoSegmentsIsNoFartherThanAnyOther) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p0 = random_point(random), p1 = random_point(random), q0 = random_point(random);
    const Vec3 q1 = i % 3 == 0 ? Vec3(q0 + 0.7 * (p1 - p0)) : random_point(random);  // a third of them parallel
    const SegmentPair best = closest_of_segments(p0, p1, q0, q1);
    ASSERT_TRUE(best.s >= 0.0 && best.s <= 1.0 && best.t >= 0.0 && best.t <= 1.0);
    const auto distance = [&](double s, double t) { return (p0 + s * (p1 - p0) - q0 - t * (q1 - q0)).norm(); };
    const double d = distance(best.s, best.t);
    for (int a = 0; a <= 20; ++a)
      for (int b = 0; b <= 20; ++b) EXPECT_LE(d, distance(a / 20.0, b / 20.0) + 1e-12);
  }
}

TEST(ClosestPoint, OfSegmentsWithoutLengthIsFinite) {
  const Vec3 a(1.0, 0.0, 0.0), b(0.0, 2.0, 0.0);
  EXPECT_EQ(closest_of_segments(a, a, b, b).s, 0.0);
  EXPECT_NEAR(closest_of_segments(a, a, Vec3::Zero(), b).t, 0.0, 1e-15);
  EXPECT_NEAR(closest_of_segments(Vec3::Zero(), b, a + b, a + b).s, 1.0, 1e-15);
}

}  // namespace
}  // namespace slipstitch
