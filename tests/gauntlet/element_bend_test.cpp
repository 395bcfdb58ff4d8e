// SPDX-License-Identifier: MIT
// Bends from exactly straight to exactly folded, and over arc lengths that go to nothing.
#include <gtest/gtest.h>

#include "force/bending.h"
#include "force/bending_jamming.h"
#include "force/plasticity.h"
#include "gauntlet/element_fixture.h"

namespace slipstitch::testing {
namespace {

constexpr double kStiffness = 4.5e-8, kLength = 1e-3;  // EI [N m^2], [m]
constexpr double kSetAngle = 0.8;
constexpr JammingParameters kJamming{kStiffness, 6.9, 2.0};
constexpr double kJamsFrom = kPi / (2 * kLength);

class ElementBend : public Element {};

struct Bent {
  const char* name;
  double (*energy)(const Vec<11>&, Vec<11>*, Mat<11>*);
  Real (*real)(const Real& theta, const Real& arc);
};

Real real_bending(const Real& theta, const Real& arc) { return Real(kStiffness) * theta * theta / arc; }

Real real_set_bending(const Real& theta, const Real& arc) {
  const Real p = kSetAngle, m = theta * theta / sqrt(theta * theta + Real(kSetSmoothing) * Real(kSetSmoothing));
  return Real(kStiffness) * (theta * theta - 2 * p * m + p * p) / arc;
}

Real real_jamming(const Real& theta, const Real& arc) {
  const Real x = (2 * theta / arc / Real(kJamsFrom) - 1) / Real(kJamming.full_at - 1.0);
  if (x <= 0) return 0;
  const Real S = x < 1 ? Real(x * x * x * (x * (6 * x - 15) + 10)) : Real(1);
  return (exp(Real(kJamming.log_max_factor) * S) - 1) * real_bending(theta, arc);
}

const std::array<Bent, 3> kBends{
    Bent{"bending", [](const Vec<11>& q, Vec<11>* g, Mat<11>* h) { return bending_energy(kStiffness, q, g, h); },
         real_bending},
    Bent{"plasticity",
         [](const Vec<11>& q, Vec<11>* g, Mat<11>* h) { return set_bending_energy(kStiffness, kSetAngle, q, g, h); },
         real_set_bending},
    Bent{"jamming",
         [](const Vec<11>& q, Vec<11>* g, Mat<11>* h) { return bending_jamming_energy(kJamming, kJamsFrom, q, g, h); },
         real_jamming}};

/// Bent by theta, or by pi less `fold` where that is given, over an arc of 2 mm times `share`.
Vec<11> bend(double theta, double fold = 0.0, double share = 1.0) {
  const double c = fold > 0.0 ? -std::cos(fold) : std::cos(theta), s = fold > 0.0 ? std::sin(fold) : std::sin(theta);
  Vec<11> q;
  q << -kLength, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.7 * kLength * c, 0.7 * kLength * s, 0.0, 2.0 * kLength * share;
  return q;
}

// By the squared sine, which has derivatives where yarn is straight; the square root of it has none.
Reference reference_of(const Bent& bent, const Vec<11>& q, double near) {
  const auto energy = [&](const Reals& x) {
    return bent.real(angle_between(point(x, 4) - point(x, 0), point(x, 7) - point(x, 4)), x[10] - x[3]);
  };
  return reference(energy, q, near);
}

TEST_F(ElementBend, HasTheRightDerivativesFromExactlyStraightOn) {
  for (const Bent& bent : kBends)
    for (const double theta : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 0.049, 0.051, 0.3, 0.5, 1.5}) {
      SCOPED_TRACE(bent.name + std::to_string(theta));
      const Vec<11> q = bend(theta, 0.0, 0.5);
      const Evaluated<11> e(bent.energy, q);
      ASSERT_TRUE(e.finite());
      expect_matches(e, reference_of(bent, q, 1e-4 * kLength * kSetSmoothing), 1e3 * kEpsilon);
    }
}

// theta is rounded by epsilon, so its distance from pi is right to epsilon/fold.
TEST_F(ElementBend, HasTheRightDerivativesUpTo1e_9FromFolded) {
  for (const Bent& bent : kBends)
    for (const double fold : {1.0, 1e-1, 1e-2, 1e-3, 1e-6, 1e-9}) {
      SCOPED_TRACE(bent.name + std::to_string(fold));
      const Vec<11> q = bend(0.0, fold);
      const Evaluated<11> e(bent.energy, q);
      ASSERT_TRUE(e.finite());
      expect_matches(e, reference_of(bent, q, 1e-2 * fold * kLength), 1e3 * kEpsilon / fold);
    }
}

// V is a cone at pi: its force is 2 pi EI/W over a length, its Hessian that over the sine, taken as 1e-12 at the least.
TEST_F(ElementBend, IsBoundedUpToExactlyFolded) {
  const double W = 2.0 * kLength, torque = 2.0 * kPi * kStiffness / W;
  std::vector<Vec<11>> folds;
  for (const double fold : {1e-9, 1e-11, 1e-12, 1e-13, 1e-15, 1e-18, 1e-300}) folds.push_back(bend(0.0, fold));
  Vec<11> exact = bend(kPi);
  exact[8] = 0.0;
  folds.push_back(exact);
  for (const Vec<11>& q : folds) {
    const Evaluated<11> e(kBends[0].energy, q);
    ASSERT_TRUE(e.finite());
    EXPECT_NEAR(e.V, kStiffness * kPi * kPi / W, 1e-8 * kStiffness * kPi * kPi / W);
    EXPECT_LE(e.g.norm(), 5.0 * torque / kLength);
    EXPECT_LE(e.hess.norm(), 20.0 * torque / (kLength * kLength) / 1e-12);
    for (const Bent& bent : kBends) EXPECT_TRUE(Evaluated<11>(bent.energy, q).finite()) << bent.name;
  }
}

TEST_F(ElementBend, ConvexHessianIsFiniteFromStraightToFolded) {
  for (Vec<11> q : {bend(0.0), bend(1e-15), bend(1e-9), bend(1.0), bend(0.0, 1e-9), bend(0.0, 1e-15), bend(kPi)}) {
    Mat<11> hess;
    convex_set_bending(kStiffness, kSetAngle, q, hess);
    EXPECT_TRUE(hess.allFinite());
    EXPECT_GE(hess.diagonal().minCoeff(), 0.0);
    q[8] = 0.0;
    convex_set_bending(kStiffness, kSetAngle, q, hess);
    EXPECT_TRUE(hess.allFinite());
  }
}

// V ~ 1/W, g ~ 1/W^2, hess ~ 1/W^3.
TEST_F(ElementBend, IsRightAndGrowsNoFasterThanItMustAsTheArcLengthGoesToNothing) {
  for (const Bent& bent : kBends)
    for (const double share : decades(-15)) {
      SCOPED_TRACE(bent.name + std::to_string(share));
      const Vec<11> q = bend(1.0, 0.0, share);
      const Evaluated<11> e(bent.energy, q);
      ASSERT_TRUE(e.finite());
      expect_matches(e, reference_of(bent, q, 1e-4 * share * kLength), 1e3 * kEpsilon);
      const double factor = std::exp(kJamming.log_max_factor) * 100.0 * kStiffness;
      EXPECT_LE(e.V, factor / (share * kLength));
      EXPECT_LE(e.g.norm(), factor / std::pow(share * kLength, 2));
      EXPECT_LE(e.hess.norm(), factor / std::pow(share * kLength, 3));
    }
}

TEST_F(ElementBend, IsInfiniteWithoutDerivativesWhereThereIsNoArcLength) {
  for (const Bent& bent : kBends)
    for (const double share : {0.0, -1e-12, -1.0}) {
      const Evaluated<11> e(bent.energy, bend(1.0, 0.0, share));
      EXPECT_EQ(e.V, std::numeric_limits<double>::infinity()) << bent.name;
      EXPECT_EQ(e.g, (Vec<11>::Zero())) << bent.name;
      EXPECT_EQ(e.hess, (Mat<11>::Zero())) << bent.name;
    }
}

TEST_F(ElementBend, SeriesAndClosedFormOfItsDerivativesJoin) {
  for (const double gap : {1e-6, 1e-9, 1e-12}) {
    const Evaluated<11> series(kBends[0].energy, bend(0.05 - gap)), closed(kBends[0].energy, bend(0.05 + gap));
    EXPECT_LE((series.hess - closed.hess).norm(), (10 * gap + 1e4 * kEpsilon) * closed.hess.norm());
  }
}

}  // namespace
}  // namespace slipstitch::testing
