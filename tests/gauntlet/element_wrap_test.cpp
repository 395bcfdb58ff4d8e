// SPDX-License-Identifier: MIT
// Wraps with triangles from healthy to flat and with edges from healthy to none.
#include "gauntlet/element_fixture.h"
#include "gauntlet/wrap_reference.h"

namespace slipstitch::testing {
namespace {

constexpr double kStiffness = 4.5e-5;  // of the demo yarn: EI/L [N m]
constexpr std::array kOffsets{0.0, -kPi* kPi / 6};

class ElementWrap : public Element {};

auto in_use(const Wrap& wrap, double offset) {
  return [=](const Vec<12>& q, Vec<12>* g, Mat<12>* h) { return wrapping_energy(wrap, offset, q, g, h); };
}
auto bare(double rest) {
  return [=](const Vec<12>& q, Vec<12>* g, Mat<12>* h) { return bare_wrapping_energy(kStiffness, rest, q, g, h); };
}

Wrap wrap_at(double rest) { return {kStiffness, rest, kRestLength}; }

/// Hinges with one triangle of that height, with the other, and with both; over the axis and beyond its ends.
std::vector<Hinge> flat_hinges(double height) {
  std::vector<Hinge> hinges;
  for (const double foot : {0.4, 1.7, -0.6}) {
    hinges.push_back({.height_a = height, .foot_a = foot});
    hinges.push_back({.height_b = height, .foot_b = foot});
    hinges.push_back({.height_a = height, .height_b = height, .foot_a = foot});
  }
  return hinges;
}

/// Hinges with an axis or an arm of that length, the triangles' angles at the axis' ends healthy.
std::vector<Hinge> short_hinges(double length) {
  Hinge axis{.axis = length};
  axis.foot_b += length - 1.0;
  return {axis,
          {.height_a = 0.8 * length, .foot_a = 0.6 * length},
          {.height_b = 0.8 * length, .foot_b = 1.0 + 0.6 * length}};
}

// Rounding of a coordinate is 1/height times larger as seen from the axis.
TEST_F(ElementWrap, AngleHasTheRightDerivativesDownToHeightsOf1e_9) {
  for (const double height : decades())
    for (const Hinge& hinge : flat_hinges(height)) {
      const Vec<12> q = hinge.turned(2.9);
      const auto energy = [](const Reals& x) {
        const Real t = real_wrap_angle(x) - Real(0.5);
        return Real(kStiffness) * t * t / 2;
      };
      expect_matches<12>({bare(0.5), q}, reference(energy, q, 1e-2 * height * kRestLength), 64 * kEpsilon / height);
    }
}

TEST_F(ElementWrap, EnergyInUseHasTheRightDerivativesDownToHeightsOf1e_9) {
  for (const double height : decades(-8))  // at 1e-9 it is gone
    for (const Hinge& hinge : flat_hinges(height)) {
      const Vec<12> q = hinge.turned(-1.0);
      const auto energy = [](const Reals& x) { return real_wrapping_energy(wrap_at(kPi / 2), kOffsets[1], x); };
      expect_matches<12>({in_use(wrap_at(kPi / 2), kOffsets[1]), q}, reference(energy, q, 1e-2 * height * kRestLength),
                         256 * kEpsilon / height);
    }
}

TEST_F(ElementWrap, EnergyInUseHasTheRightDerivativesWhereAnEdgeHasNearlyNoLength) {
  for (const double length : {2e-3, 9e-4, 5e-4, 1e-4, 1e-6, 1e-8, 1e-10})
    for (const Hinge& hinge : short_hinges(length)) {
      const Vec<12> q = hinge.turned(-1.0);
      const auto energy = [](const Reals& x) { return real_wrapping_energy(wrap_at(kPi / 2), kOffsets[1], x); };
      expect_matches<12>({in_use(wrap_at(kPi / 2), kOffsets[1]), q}, reference(energy, q, 1e-2 * length * kRestLength),
                         256 * kEpsilon / length);
    }
}

// |psi'| <= 6/h with edges up to twice the axis, h the lower height, and |psi''| <= |psi'|^2. While nothing fades h is
// at least 0.3 times an arm, hence 0.12 L for these: |g| <= pi k 50/L and |hess| <= (1 + pi) k 2500/L^2. Fading adds
// less.
TEST_F(ElementWrap, IsBoundedHoweverFlatItsTrianglesAre) {
  for (const double offset : kOffsets)
    for (double height = 1.0; height > 1e-12; height *= 0.7)
      for (const Hinge& hinge : flat_hinges(height))
        for (const double psi : {-3.1, -1.0, 1e-12, 2.0}) {
          const Evaluated<12> e(in_use(wrap_at(kPi / 2), offset), hinge.turned(psi));
          ASSERT_TRUE(e.finite());
          EXPECT_LE(std::abs(e.V), 0.5 * kPi * kPi * kStiffness);
          EXPECT_LE(e.g.norm(), 160 * kStiffness / kRestLength);
          EXPECT_LE(e.hess.norm(), 1e4 * kStiffness / (kRestLength * kRestLength));
        }
}

// As above with h from 0.0005 L, half of where edges begin to fade.
TEST_F(ElementWrap, IsBoundedHoweverShortItsEdgesAre) {
  for (const double offset : kOffsets)
    for (double length = 1.0; length > 1e-14; length *= 0.7)
      for (const Hinge& hinge : short_hinges(length))
        for (const double psi : {-3.1, -1.0, 2.0}) {
          const Evaluated<12> e(in_use(wrap_at(kPi / 2), offset), hinge.turned(psi));
          ASSERT_TRUE(e.finite());
          EXPECT_LE(std::abs(e.V), 0.5 * kPi * kPi * kStiffness);
          EXPECT_LE(e.g.norm(), 4e4 * kStiffness / kRestLength);
          EXPECT_LE(e.hess.norm(), 6e8 * kStiffness / (kRestLength * kRestLength));
        }
}

// S of a length x of L/1000 is 10 x^3 at first: V ~ x^3, its gradient ~ x^2, its Hessian ~ x.
TEST_F(ElementWrap, VanishesWithTwoDerivativesWhereAnEdgeDoes) {
  for (std::size_t which : {0U, 1U, 2U}) {
    Evaluated<12> before(in_use(wrap_at(kPi / 2), 0.0), short_hinges(1e-6)[which].turned(-1.0));
    for (const double length : {1e-7, 1e-8, 1e-9}) {
      const Evaluated<12> now(in_use(wrap_at(kPi / 2), 0.0), short_hinges(length)[which].turned(-1.0));
      EXPECT_NEAR(before.V / now.V, 1000.0, 20.0);
      EXPECT_NEAR(before.g.norm() / now.g.norm(), 100.0, 2.0);
      EXPECT_NEAR(before.hess.norm() / now.hess.norm(), 10.0, 0.2);
      before = now;
    }
  }
}

TEST_F(ElementWrap, DoesNothingWhereAnEdgeOrEveryEdgeHasNoLength) {
  std::vector<Hinge> hinges = short_hinges(0.0);
  hinges.push_back({0.0, 0.0, 0.0, 0.0, 0.0});
  for (const Hinge& hinge : hinges) {
    const Evaluated<12> e(in_use(wrap_at(kPi / 2), kOffsets[1]), hinge.at(1.0));
    EXPECT_EQ(e.V, 0.0);
    EXPECT_EQ(e.g, (Vec<12>::Zero()));
    EXPECT_EQ(e.hess, (Mat<12>::Zero()));
    Mat<12> convex;
    convex_wrapping_hessian(wrap_at(kPi / 2), hinge.at(1.0), convex);
    EXPECT_EQ(convex, (Mat<12>::Zero()));
  }
}

// The same force to the last bit; the other two are multiplied in another order.
TEST_F(ElementWrap, IsTheBareEnergyUntilItFades) {
  const auto same = [](const Hinge& hinge) {
    const Evaluated<12> e(in_use(wrap_at(0.5), 0.0), hinge.turned(-1.0)), b(bare(0.5), hinge.turned(-1.0));
    return std::abs(e.V - b.V) <= 2 * kEpsilon * b.V && e.g == b.g &&
           (e.hess - b.hess).norm() <= 4 * kEpsilon * b.hess.norm();
  };
  for (const Hinge& hinge : short_hinges(kWrapFadeLength * 1.001)) EXPECT_TRUE(same(hinge));
  for (const Hinge& hinge : short_hinges(kWrapFadeLength * 0.9)) EXPECT_FALSE(same(hinge));
  for (const Hinge& hinge : flat_hinges(1.0)) EXPECT_TRUE(same(hinge));
}

// Force and torque sum to nothing but the rounding of their parts.
TEST_F(ElementWrap, KeepsEnergyForcesAndTorquesUnderRigidMotionHoweverDegenerate) {
  for (const double small : decades())
    for (const auto& hinges : {flat_hinges(small), short_hinges(small)})
      for (const Hinge& hinge : hinges) {
        const Vec<12> here = hinge.at(-1.0), there = hinge.turned(-1.0);
        const Evaluated<12> a(in_use(wrap_at(kPi / 2), 0.0), here), b(in_use(wrap_at(kPi / 2), 0.0), there);
        const double noise = 16 * kEpsilon * here.norm();
        EXPECT_NEAR(a.V, b.V, noise * a.g.norm() + noise * noise * a.hess.norm() + 16 * kEpsilon * a.V);
        Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
        for (int n = 0; n < 4; ++n) {
          const Vec3 f = b.g.segment<3>(3 * n), x = there.segment<3>(3 * n);
          force += f;
          torque += x.cross(f);
        }
        EXPECT_LE(force.norm(), 16 * kEpsilon * b.g.norm() + noise * b.hess.norm());
        EXPECT_LE(torque.norm(), (16 * kEpsilon * b.g.norm() + noise * b.hess.norm()) * there.norm());
      }
}

}  // namespace
}  // namespace slipstitch::testing
