// SPDX-License-Identifier: MIT
#include "force/wrap_fade.h"

#include <gtest/gtest.h>

#include <cmath>

#include "difference_check.h"
#include "force/wrapping.h"
#include "wrap_samples.h"

namespace slipstitch::testing {
namespace {

constexpr double kMm = 1e-3;

// A hinge whose x4 and x3 stand at the given sines to the axis.
Vec<12> hinge_with_sines(double sin_a, double sin_b, double side_a, double side_b) {
  Vec<12> q;
  q << 0, 0, 0, 1, 0, 0, 1 + side_b * std::sqrt(1 - sin_b * sin_b), 0.6 * sin_b, -0.8 * sin_b,
      side_a * std::sqrt(1 - sin_a * sin_a), sin_a, 0;
  return kMm * q;
}

double fade_of(const Vec<12>& q) { return wrap_fade(q, kMm); }

TEST(WrapFade, IsOneOutsideAndZeroOnTheAxisAtEitherSide) {
  for (double side : {-1.0, 1.0}) {
    EXPECT_EQ(fade_of(hinge_with_sines(0.301, 0.9, side, 1)), 1.0);
    EXPECT_LT(fade_of(hinge_with_sines(0.299, 0.9, side, 1)), 1.0);
    EXPECT_LT(fade_of(hinge_with_sines(0.9, 0.299, 1, side)), 1.0);
    EXPECT_NEAR(fade_of(hinge_with_sines(0.15, 0.15, side, side)), 0.25, 1e-15);
    EXPECT_EQ(fade_of(hinge_with_sines(0.0, 0.9, side, 1)), 0.0);
    EXPECT_EQ(fade_of(hinge_with_sines(0.9, 0.0, 1, side)), 0.0);
  }
}

TEST(WrapFade, ReportsTheValueThatItDifferentiates) {
  for (double s : {0.5, 0.29, 0.1, 1e-3}) {
    const Vec<12> q = hinge_with_sines(s, 0.2, -1, 1);
    const auto eval = [](const Vec<12>& at, Vec<12>* g, Mat<12>* h) { return wrap_fade_derivatives(at, kMm, g, h); };
    EXPECT_EQ(eval(q, nullptr, nullptr), fade_of(q));
    expect_exact_derivatives(q, 1e-3 * s * kMm, 2, with_dynamic_size<12>(eval));
  }
}

// All of value, gradient and Hessian of the energy in use.
struct Evaluated {
  double V;
  Vec<12> g;
  Mat<12> hess;
  Evaluated(const Vec<12>& q, double rest, double offset) { V = wrapping_energy({1.0, rest, kMm}, offset, q, &g, &hess); }
};

constexpr std::array<double, 2> kOffsets{0.0, -kPi* kPi / 6};

TEST(WrapFade, EnergyIsTwiceContinuouslyDifferentiableWhereItStartsToFade) {
  for (double offset : kOffsets) {
    double jump_before = 0.0;
    for (double gap : {1e-3, 1e-4, 1e-5}) {  // the Hessian's jump over the edge shrinks with the gap
      const Evaluated in(hinge_with_sines(kWrapFadeSine - gap, 0.9, -1, 1), 1.5, offset);
      const Evaluated out(hinge_with_sines(kWrapFadeSine + gap, 0.9, -1, 1), 1.5, offset);
      const double jump = (in.hess - out.hess).norm() / out.hess.norm();
      EXPECT_NEAR(in.V, out.V, 10 * gap * std::abs(out.V));
      if (jump_before > 0.0) {
        EXPECT_NEAR(jump_before / jump, 10.0, 1.5);
      }
      jump_before = jump;
    }
  }
}

TEST(WrapFade, EnergyAndDerivativesVanishTowardsTheAxis) {
  for (double offset : kOffsets) {
    for (double side : {-1.0, 1.0}) {
      Evaluated before(hinge_with_sines(1e-3, 0.9, side, 1), 1.5, offset);
      for (double s : {1e-4, 1e-5, 1e-6, 1e-7}) {  // V ~ s^3, gradient ~ s^2, Hessian ~ s
        const Evaluated now(hinge_with_sines(s, 0.9, side, 1), 1.5, offset);
        EXPECT_NEAR(before.V / now.V, 1000.0, 10.0);
        EXPECT_NEAR(before.g.norm() / now.g.norm(), 100.0, 1.0);
        EXPECT_NEAR(before.hess.norm() / now.hess.norm(), 10.0, 0.1);
        before = now;
      }
    }
  }
}

TEST(WrapFade, NothingActsAndNothingIsNotANumberOnTheAxis) {
  Vec<12> points = Vec<12>::Zero();
  for (const Vec<12>& q : {hinge_with_sines(0.0, 0.9, -1, 1), hinge_with_sines(1e-10, 0.9, -1, 1),
                           hinge_with_sines(0.9, 0.0, 1, 1), hinge_with_sines(0.0, 0.0, 1, -1), points}) {
    const Evaluated e(q, 1.5, 0.0);
    EXPECT_EQ(e.V, 0.0);
    EXPECT_EQ(e.g, (Vec<12>::Zero()));
    EXPECT_EQ(e.hess, (Mat<12>::Zero()));
    EXPECT_TRUE(std::isfinite(wrap_angle(node(q, 0), node(q, 1), node(q, 2), node(q, 3))));
  }
}

TEST(WrapWell, IsTheParabolaAwayFromTheCapAndFlatAtItsTop) {
  for (double t : {-3.0, -1.0, 0.0, 0.5, kPi - kWrapCapWidth}) {
    const Jet2 E = wrap_well(t);
    EXPECT_EQ(E.f, 0.5 * t * t);
    EXPECT_EQ(E.d, t);
    EXPECT_EQ(E.dd, 1.0);
    EXPECT_FALSE(wrap_in_cap(t));
  }
  for (double t : {-kPi, kPi}) {
    EXPECT_EQ(wrap_well(t).d, 0.0);
    EXPECT_EQ(wrap_well(t).dd, 0.0);
    EXPECT_TRUE(wrap_in_cap(t));
  }
  EXPECT_EQ(wrap_well(kPi).f, wrap_well(-kPi).f);
}

TEST(WrapWell, DerivativesAreExactThroughTheCap) {
  for (double t = -3.14; t < 3.14; t += 0.013) {
    const auto eval = [](const Vec<1>& at, Vec<1>* g, Mat<1>* h) {
      const Jet2 E = wrap_well(at[0]);
      if (g) (*g)[0] = E.d;
      if (h) (*h)(0, 0) = E.dd;
      return E.f;
    };
    expect_exact_derivatives(Vec<1>(t), 1e-4, 1, with_dynamic_size<1>(eval));
  }
}

TEST(WrapWell, CapJoinsTheParabolaAndItselfWithTwoContinuousDerivatives) {
  for (double edge : {kPi - kWrapCapWidth, kPi}) {
    for (double gap : {1e-3, 1e-5, 1e-7}) {
      const double beyond = wrap_excess(edge + gap, 0.0);  // past pi: round to -pi
      const Jet2 in = wrap_well(edge - gap), out = wrap_well(beyond);
      EXPECT_NEAR(in.f, out.f, 10 * gap);
      EXPECT_NEAR(in.d, out.d, 10 * gap);
      EXPECT_NEAR(in.dd, out.dd, 4e5 * gap * gap + 1e-12);  // smoothstep' starts like 30 x^2, x = gap/0.1
    }
  }
}

TEST(WrapWell, ExcessIsTheShortWayRound) {
  EXPECT_DOUBLE_EQ(wrap_excess(-3.0, kPi / 2), -3.0 - kPi / 2 + 2 * kPi);
  EXPECT_DOUBLE_EQ(wrap_excess(3.0, -kPi / 2), 3.0 + kPi / 2 - 2 * kPi);
  EXPECT_DOUBLE_EQ(wrap_excess(1.0, kPi / 2), 1.0 - kPi / 2);
}

}  // namespace
}  // namespace slipstitch::testing
