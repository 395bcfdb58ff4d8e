// SPDX-License-Identifier: MIT
// Arc lengths inside contacts and between them, and gaps, that shrink to nothing.
#include <gtest/gtest.h>

#include "force/contact_length.h"
#include "force/gap_energy.h"
#include "force/parallel_contact.h"
#include "gauntlet/element_fixture.h"

namespace slipstitch::testing {
namespace {

constexpr double kStiffness = 50.0, kRest = 1.7e-4, kDistance = 1.2e-4;  // of the demo yarn

class ElementLength : public Element {};

TEST_F(ElementLength, ContactLengthHoldsASegmentThatShrinksToNothingAndBeyond) {
  const auto energy = [](const Vec<2>& q, Vec<2>* g, Mat<2>* h) {
    return contact_length_energy(kStiffness, kRest, q, g, h);
  };
  const auto real = [](const Reals& q) {
    const Real strain = (q[1] - q[0]) / Real(kRest) - 1;
    return Real(kStiffness) / 2 * Real(kRest) * strain * strain;
  };
  std::vector<double> shares = decades();
  shares.insert(shares.end(), {0.0, -1e-9, -1.0});
  for (const double share : shares) {
    const Vec<2> q(0.0, share * kRest);
    const Evaluated<2> e(energy, q);
    if (share < 1.0) expect_matches(e, reference(real, q, kRest), 8 * kEpsilon);
    EXPECT_LE(e.V, 2.0 * kStiffness * kRest * (1.0 + kEpsilon));
  }
  EXPECT_EQ(energy(Vec<2>(0.0, kRest), nullptr, nullptr), 0.0);
}

Real real_barrier(const Real& scale, const Real& r) {
  return r < 1 ? Real(-scale * (r - 1) * (r - 1) * log(r)) : Real(0);
}

TEST_F(ElementLength, ParallelContactIsRightAndRisesWithoutBoundAsNeighboursMeet) {
  const double k = 6e7;
  const auto energy = [=](const Vec<2>& q, Vec<2>* g, Mat<2>* h) {
    return parallel_contact_barrier(k, kRest, kDistance, q, g, h);
  };
  const auto real = [=](const Reals& q) {
    return real_barrier(Real(k) * kRest * Real(kDistance) * kDistance, (q[1] - q[0]) / (Real(kDistance) / 2));
  };
  double before = 0.0;
  for (const double share : decades(-12)) {
    const Vec<2> q(0.0, 0.4 * share * kDistance);
    const Evaluated<2> e(energy, q);
    ASSERT_TRUE(e.finite());
    expect_matches(e, reference(real, q, 0.1 * q[1]), 64 * kEpsilon);
    EXPECT_GT(e.V, before);
    EXPECT_LT(e.g[1], 0.0);
    before = e.V;
  }
  for (const double arc : {0.0, -1e-9 * kDistance, -kDistance})
    EXPECT_EQ(energy(Vec<2>(0.0, arc), nullptr, nullptr), std::numeric_limits<double>::infinity());
}

TEST_F(ElementLength, GapEnergyIsRightDownToItsDeepestOverlapAndInfiniteBeyond) {
  const double k = 10.0, w = 1e-5;
  const auto energy = [=](const Vec<1>& q, Vec<1>* g, Mat<1>* h) {
    const GapEnergy e = gap_energy(k, w, q[0]);
    *g << e.slope;
    *h << e.curvature;
    return e.value;
  };
  const auto real = [=](const Reals& q) { return real_barrier(Real(k) * w, 1 + q[0] / Real(w)); };
  for (const double left : decades(-12)) {  // of w; rounding of 1 + gap/w counts against it
    const Vec<1> q(-w * (1.0 - 0.9 * left));
    const Evaluated<1> e(energy, q);
    ASSERT_TRUE(e.finite());
    expect_matches(e, reference(real, q, 0.1 * left * w), 16 * kEpsilon / left);
  }
  for (const double overlap : {1e-1, 1e-3, 1e-6, 1e-9, 1e-15, 1e-300}) {  // V ~ gap^3: C2 where touch begins
    const GapEnergy e = gap_energy(k, w, -overlap * w);
    EXPECT_LE(std::abs(e.value), 2.0 * k * w * std::pow(overlap, 3));
    EXPECT_LE(std::abs(e.slope), 6.0 * k * overlap * overlap);
    EXPECT_LE(std::abs(e.curvature), 12.0 * k / w * overlap);
  }
  for (const double gap : {-w, -1.5 * w, -1.0, -std::numeric_limits<double>::max()}) {
    EXPECT_EQ(gap_energy(k, w, gap).value, std::numeric_limits<double>::infinity());
    EXPECT_EQ(gap_energy(k, w, gap).slope, 0.0);
  }
  EXPECT_EQ(gap_energy(k, w, 0.0).value, 0.0);
}

}  // namespace
}  // namespace slipstitch::testing
