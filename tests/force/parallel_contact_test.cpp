// SPDX-License-Identifier: MIT
#include "force/parallel_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "difference_check.h"
#include "evaluation.h"

namespace slipstitch::testing {
namespace {

constexpr double k_c = 6e7, L = 1.7e-4, d = 1.2e-4;  // the head of a stitch of the demo yarn

double barrier(double D, Vec<2>* g = nullptr, Mat<2>* hess = nullptr) {
  return parallel_contact_barrier(k_c, L, d, Vec<2>(3e-3, 3e-3 + D), g, hess);
}

TEST(ParallelContactBarrier, IsZeroFromHalfTheDistanceOnAndJoinsTwiceDifferentiably) {
  Vec<2> g;
  Mat<2> hess;
  EXPECT_EQ(barrier(0.5 * d * (1.0 + 1e-9), &g, &hess), 0.0);
  EXPECT_EQ(g.norm() + hess.norm(), 0.0);
  const double scale = k_c * L;
  EXPECT_GT(barrier(0.5 * d * (1.0 - 1e-4), &g, &hess), 0.0);
  EXPECT_LT(g.norm(), 1e-5 * scale * d);
  EXPECT_LT(hess.norm(), 1e-2 * scale);
}

TEST(ParallelContactBarrier, HasExactDerivativesAndIsConvex) {
  for (double share : {0.4, 0.1, 1e-2, 1e-4}) {
    const Vec<2> q(0.0, share * d);
    const auto eval = [](const Vec<2>& at, Vec<2>* g, Mat<2>* h) {
      return parallel_contact_barrier(k_c, L, d, at, g, h);
    };
    expect_exact_derivatives(q, 1e-3 * share * d, 2, with_dynamic_size<2>(eval));
    Mat<2> hess;
    barrier(share * d, nullptr, &hess);
    EXPECT_GT(hess(1, 1), 0.0) << share;
  }
}

TEST(ParallelContactBarrier, HoldsAnyTension) {
  Vec<2> g;
  for (double tension : {10.0, 1e3, 1e6}) {
    double low = 0.0, high = 0.5 * d;
    for (int i = 0; i < 200; ++i) {
      const double D = 0.5 * (low + high);
      barrier(D, &g);
      (-g[1] > tension ? low : high) = D;
    }
    EXPECT_GT(high, 1e-6 * d * 10.0 / tension) << tension;
  }
  EXPECT_TRUE(std::isinf(barrier(0.0)));
  EXPECT_TRUE(std::isinf(barrier(-1e-9)));
}

}  // namespace
}  // namespace slipstitch::testing
