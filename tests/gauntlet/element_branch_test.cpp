// SPDX-License-Identifier: MIT
// Wraps near psi = 0, where the arccos of the published formula and its 1/sin psi break, and across +-pi.
#include "gauntlet/element_fixture.h"
#include "gauntlet/wrap_reference.h"

namespace slipstitch::testing {
namespace {

class ElementBranch : public Element {};

constexpr double kTurned = 16 * kEpsilon;  // rounding of psi between healthy triangles

double angle_of(const Vec<12>& q) {
  return wrap_angle(q.segment<3>(0), q.segment<3>(3), q.segment<3>(6), q.segment<3>(9));
}

auto angle() {
  return [](const Vec<12>& q, Vec<12>* g, Mat<12>* h) { return wrap_angle_derivatives(q, g, h); };
}
auto in_use(double rest, double offset) {
  return [=](const Vec<12>& q, Vec<12>* g, Mat<12>* h) {
    return wrapping_energy({1.0, rest, kRestLength}, offset, q, g, h);
  };
}

// psi less `from`, by the reference and in double: all of them finite, and the derivatives to round-off.
void expect_right_angle(double psi, double sign) {
  const Vec<12> q = Hinge{}.turned(psi);
  const Evaluated<12> e(angle(), q);
  const Reference r = reference(real_wrap_angle, q, 1e-3 * kRestLength);
  EXPECT_NEAR(e.V, r.V, kTurned);
  EXPECT_EQ(std::signbit(Hinge{}.at(psi)[8]), sign > 0.0);
  EXPECT_EQ(std::signbit(angle_of(Hinge{}.at(psi))), sign < 0.0) << psi;
  EXPECT_LE((e.g - r.g).norm(), kTurned * r.g.norm());
  EXPECT_LE((e.hess - r.hess).norm(), kTurned * r.hess.norm());
}

TEST_F(ElementBranch, AngleAndDerivativesAreRightWithin1e_12OfZeroAndOfPi) {
  for (const double sign : {-1.0, 1.0})
    for (const double delta : {1e-3, 1e-6, 1e-9, 1e-12}) {
      expect_right_angle(sign * delta, sign);
      expect_right_angle(sign * (kPi - delta), sign);
    }
}

TEST_F(ElementBranch, AngleAndDerivativesAreThoseInOnePlaneAndFoldedFlat) {
  for (const double height : {-0.8, 0.8}) {  // x3 across the axis from x4, and over it
    const Vec<12> q = Hinge{.height_b = height}.at(0.0);
    const Evaluated<12> e(angle(), q);
    EXPECT_EQ(std::abs(e.V), height > 0.0 ? 0.0 : kPi);
    ASSERT_TRUE(e.finite());
    // Only what lifts a node out of the plane turns the hinge, by 1/height at x3 and x4.
    EXPECT_NEAR(e.g[8] * height * kRestLength, -1.0, 1e-14);
    EXPECT_NEAR(std::abs(e.g[11] * 0.8 * kRestLength), 1.0, 1e-14);
    for (int n = 0; n < 4; ++n) EXPECT_EQ(e.g.segment<2>(3 * n).norm(), 0.0);
  }
}

TEST_F(ElementBranch, MirroredHingesHaveMirroredEnergyBitForBit) {
  Vec<12> flip;
  for (int i = 0; i < 12; ++i) flip[i] = i % 3 == 2 ? -1.0 : 1.0;
  for (const double psi : {1e-12, 1e-6, 0.3, 1.5, 3.0, 3.1, kPi - 1e-12})
    for (const double height : {0.8, 0.1, 1e-6}) {
      const Vec<12> q = Hinge{.height_a = height}.at(psi), mirrored = flip.cwiseProduct(q);
      EXPECT_EQ(angle_of(mirrored), -angle_of(q));
      const Evaluated<12> a(in_use(0.7, -1.0), q), b(in_use(-0.7, -1.0), mirrored);
      EXPECT_EQ(a.V, b.V);
      EXPECT_EQ(a.g, Vec<12>(flip.cwiseProduct(b.g)));
      EXPECT_EQ(a.hess, Mat<12>(flip.asDiagonal() * b.hess * flip.asDiagonal()));
    }
}

// The well is flat at its top, so its Hessian changes there by 60/0.1 a radian at most, times |psi'|^2 ~ 10/L^2.
void expect_continuous(double psi, double rest, double offset) {
  for (const double gap : {1e-4, 1e-8, 1e-12}) {
    const Evaluated<12> before(in_use(rest, offset), Hinge{}.turned(psi - gap));
    const Evaluated<12> after(in_use(rest, offset), Hinge{}.turned(psi + gap));
    const double rounding = 1e3 * kEpsilon;
    EXPECT_NEAR(before.V, after.V, 10 * gap + rounding) << psi << " " << rest;
    EXPECT_LE((before.g - after.g).norm() * kRestLength, 100 * gap + rounding) << psi << " " << rest;
    EXPECT_LE((before.hess - after.hess).norm() * kRestLength * kRestLength, 2e4 * gap + 1e3 * rounding)
        << psi << " " << rest;
  }
}

TEST_F(ElementBranch, EnergyIsTwiceContinuousAcrossPiAndAcrossItsRidge) {
  for (const double offset : {0.0, -kPi * kPi / 6})
    for (const double rest : {kPi / 2, -kPi / 2, 0.0, 3.0, -3.0, kPi}) {
      expect_continuous(kPi, rest, offset);
      expect_continuous(rest + kPi, rest, offset);                  // the ridge
      expect_continuous(rest + kPi - kWrapCapWidth, rest, offset);  // where its cap begins
      expect_continuous(rest - kPi + kWrapCapWidth, rest, offset);
      expect_continuous(0.0, rest, offset);
    }
}

TEST_F(ElementBranch, ForcePushesTheShortWayRoundOnEitherSideOfPi) {
  for (const double rest : {kPi / 2, -kPi / 2})
    for (const double gap : {1e-3, 1e-12}) {
      const Evaluated<12> e(in_use(rest, 0.0), Hinge{}.at(kPi - gap)), f(in_use(rest, 0.0), Hinge{}.at(gap - kPi));
      Vec<12> turn;
      wrap_angle_derivatives(Hinge{}.at(kPi - gap), &turn, nullptr);
      const double sign = rest > 0.0 ? 1.0 : -1.0;
      EXPECT_NEAR(e.g.dot(turn) / turn.squaredNorm(), sign * (kPi / 2 - sign * gap), 1e-12);
      EXPECT_NEAR(f.V, 0.5 * std::pow(kPi / 2 + sign * gap, 2), 1e-12);
    }
}

TEST_F(ElementBranch, EnergyHasTheRightDerivativesThroughTheCap) {
  for (const double left : {0.099, 0.05, 0.03, 1e-3}) {  // to the ridge, where the force is (left/0.1)^3 of its own
    const Vec<12> q = Hinge{}.turned(left > 0.04 ? left - kPi : kPi - left);
    const auto energy = [](const Reals& x) { return real_wrapping_energy({1.0, 0.0, kRestLength}, 0.0, x); };
    const double rounding = 64 * kEpsilon / std::pow(left / kWrapCapWidth, 3);
    expect_matches<12>({in_use(0.0, 0.0), q}, reference(energy, q, 1e-4 * kRestLength), rounding);
  }
}

}  // namespace
}  // namespace slipstitch::testing
