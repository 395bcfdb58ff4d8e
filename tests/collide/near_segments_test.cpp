// SPDX-License-Identifier: MIT
#include "collide/near_segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace slipstitch {
namespace {

constexpr int kSegments = 60;
constexpr double kReach = 0.1, kMargin = 0.05;

std::vector<std::array<int, 6>> loose_segments() {
  std::vector<std::array<int, 6>> segments;
  for (int i = 0; i < kSegments; ++i)
    segments.push_back({6 * i, 6 * i + 1, 6 * i + 2, 6 * i + 3, 6 * i + 4, 6 * i + 5});
  return segments;
}

/// Every odd one with every even one.
double touch(int a, int b) { return (a + b) % 2 == 0 ? -1.0 : 0.5 * kReach; }

/// Checks the pairs of a way against all there are. Returns how many come within reach.
int expect_covered(NearSegments& near, const VecX& q, const VecX& dq) {
  const auto segments = loose_segments();
  near.cover(q, dq, touch);
  std::set<std::array<int, 2>> found;
  for (const NearSegments::Pair& pair : near.pairs()) {
    EXPECT_LT(pair.a, pair.b);
    EXPECT_EQ(pair.touch, touch(pair.a, pair.b));
    EXPECT_GE(pair.touch, 0.0);
    EXPECT_TRUE(found.insert({pair.a, pair.b}).second) << "twice: " << pair.a << ", " << pair.b;
  }
  const auto least = [&](int a, int b) {
    double d = 1e3;
    for (int k = 0; k <= 20; ++k)
      d = std::min(d, distance_of_segments(segments[static_cast<std::size_t>(a)], segments[static_cast<std::size_t>(b)],
                                           q + k / 20.0 * dq));
    return d;
  };
  for (const NearSegments::Pair& pair : near.pairs()) EXPECT_LE(near.at_least(pair), least(pair.a, pair.b) + 1e-12);
  int close = 0;
  for (int a = 0; a < kSegments; ++a)
    for (int b = a + 1; b < kSegments; ++b) {
      if (touch(a, b) < 0.0 || least(a, b) > kReach) continue;
      ++close;
      EXPECT_TRUE(found.contains({a, b})) << a << ", " << b;
    }
  return close;
}

class NearSegmentsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::srand(7);
    q = 0.3 * VecX::Random(6 * kSegments);
    for (int i = 0; i < kSegments; ++i) q.segment<3>(6 * i + 3) = q.segment<3>(6 * i) + 0.1 * VecX::Random(3);
  }
  /// From where the last way ended.
  int go(const VecX& dq) {
    const int close = expect_covered(near, q, dq);
    q += dq;
    return close;
  }
  VecX nothing() const { return VecX::Zero(q.size()); }
  VecX anywhere(double far) const { return far * VecX::Random(q.size()); }

  NearSegments near{loose_segments(), kReach, kMargin};
  VecX q;
};

TEST_F(NearSegmentsTest, FindsAllThatComeNearOnShortAndLongWays) {
  EXPECT_GT(go(nothing()), 10);
  for (int k = 0; k < 40; ++k) go(anywhere(0.3 * kMargin));
  EXPECT_GT(go(anywhere(1.0)), 100);
  EXPECT_GT(go(anywhere(0.1 * kMargin)), 10);
}

TEST_F(NearSegmentsTest, FindsWhatFewStraysComeNear) {
  go(nothing());
  for (int k = 0; k < 10; ++k) {
    VecX dq = anywhere(0.02 * kMargin);
    dq.segment<6>(6 * k) = VecX::Random(6);
    dq.segment<6>(6 * k + 12) = VecX::Random(6);
    go(dq);
  }
  EXPECT_GT(go(nothing()), 10);
}

TEST_F(NearSegmentsTest, DoesNotSearchAgainWhereAllMoveTogether) {
  go(nothing());
  int asked = 0;
  const auto counted = [&](int a, int b) { return ++asked, touch(a, b); };
  VecX dq = anywhere(0.1 * kMargin);
  for (int i = 0; i < 2 * kSegments; ++i) dq.segment<3>(3 * i) += Vec3(5.0, -3.0, 2.0);
  near.cover(q, dq, counted);
  EXPECT_EQ(asked, 0);
  expect_covered(near, q, dq);
  dq.segment<3>(30) += Vec3(2.0 * kMargin, 0.0, 0.0);
  near.cover(q, dq, counted);
  EXPECT_GT(asked, 0);
}

}  // namespace
}  // namespace slipstitch
