// SPDX-License-Identifier: MIT
// Segments from slack to taut, of an arc length or a length that goes to nothing.
#include <Eigen/Eigenvalues>
#include <optional>

#include "force/stretch.h"
#include "gauntlet/element_fixture.h"
#include "gauntlet/high_precision.h"

namespace slipstitch::testing {
namespace {

constexpr double kStiffness = 50.0, kLength = 1e-3;  // EA [N], [m]

class ElementStretch : public Element {};

Real real_stretch(const Reals& q) {
  const Real D = q[7] - q[3], strain = length(point(q, 4) - point(q, 0)) / D - 1;
  return Real(kStiffness) / 2 * D * strain * strain;
}

double stretch(const Vec<8>& q, Vec<8>* g, Mat<8>* h) { return stretch_energy(kStiffness, q, g, h); }

/// A segment of that length and arc length, in no special direction.
Vec<8> segment(double length, double arc) {
  Vec<8> q;
  q << 0.0, 0.0, 0.0, 0.0, length * Vec3(1, 2, -2) / 3.0, arc;
  return q;
}

// |g| <= 2 k lambda^2 and |hess| <= 8 k lambda^2/D, lambda = |d|/D >= 1.
TEST_F(ElementStretch, IsRightAndGrowsNoFasterThanItMustAsTheArcLengthGoesToNothing) {
  for (double share : decades(-15)) {
    const Vec<8> q = segment(kLength, share * kLength);
    const Evaluated<8> e(stretch, q);
    ASSERT_TRUE(e.finite());
    if (share < 1.0) expect_matches(e, reference(real_stretch, q, 0.1 * share * kLength), 64 * kEpsilon);
    const double lambda = 1.0 / share;
    EXPECT_LE(e.g.norm(), 2.0 * kStiffness * lambda * lambda + kEpsilon);
    EXPECT_LE(e.hess.norm(), 8.0 * kStiffness * lambda * lambda * lambda / kLength);
  }
}

TEST_F(ElementStretch, IsInfiniteWithoutDerivativesWhereThereIsNoArcLength) {
  for (const double arc : {0.0, -1e-12, -kLength})
    for (const double length : {0.0, kLength}) {
      const Evaluated<8> e(stretch, segment(length, arc));
      EXPECT_EQ(e.V, std::numeric_limits<double>::infinity());
      EXPECT_EQ(e.g, (Vec<8>::Zero()));
      EXPECT_EQ(e.hess, (Mat<8>::Zero()));
    }
}

// V = k D/2 in a point; every direction away from it has the tension -k, so the Hessian turns it by k/|d|.
TEST_F(ElementStretch, OfFullyCompressedYarnIsRightAndItsForceIsItsStiffness) {
  for (double share : decades(-9)) {
    const Vec<8> q = segment(share * kLength, kLength);
    const Evaluated<8> e(stretch, q);
    ASSERT_TRUE(e.finite());
    if (share < 1.0) expect_matches(e, reference(real_stretch, q, 0.1 * share * kLength), 64 * kEpsilon);
    EXPECT_LE(e.V, 0.5 * kStiffness * kLength);
    EXPECT_LE(e.g.norm(), 2.0 * kStiffness);
    EXPECT_LE(e.hess.norm(), 4.0 * kStiffness / (share * kLength));
    Mat<8> convex;
    Model model;
    Stretch(model).convex_hessian(0, q, convex);
    EXPECT_TRUE(convex.allFinite());
  }
  const Evaluated<8> point(stretch, segment(0.0, kLength));
  ASSERT_TRUE(point.finite());
  EXPECT_EQ(point.V, 0.5 * kStiffness * kLength);
  EXPECT_EQ((point.g.head<3>().norm()), 0.0);
}

Real real_guarded(const Reals& q) {
  const Real D = q[7] - q[3], x = length(point(q, 4) - point(q, 0)) / D / Real(kCrushed);
  return real_stretch(q) - (x < 1 ? Real(Real(kStiffness) * D * (1 - x) * (1 - x) * log(x)) : Real(0));
}

/// Stretch of a model without yarn, for its energy of any segment.
class Guarded {
 public:
  Guarded() { model_.yarn.stretch_n = kStiffness, term_.emplace(model_); }
  const Stretch& term() const { return *term_; }
  double operator()(const Vec<8>& q, Vec<8>* g, Mat<8>* h) const { return term_->eval(0, q, g, h); }

 private:
  Model model_;
  std::optional<Stretch> term_;
};

TEST_F(ElementStretch, ResistsBeingPressedToAPoint) {
  const Guarded guarded;
  for (const double lambda : {0.9, 0.06, 0.0499, 0.04, 1e-2, 1e-3, 1e-6, 1e-9}) {
    const Vec<8> q = segment(lambda * kLength, kLength);
    const Evaluated<8> e(guarded, q);
    ASSERT_TRUE(e.finite());
    expect_matches(e, reference(real_guarded, q, 1e-3 * lambda * kLength), 256 * kEpsilon);
    Mat<8> convex, again;
    guarded.term().convex_hessian(0, q, convex);
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Mat<8>>(convex).eigenvalues()[0], -1e-12 * convex.norm());
    guarded.term().hessian_at(0, q, guarded.term().stress(0, q, Vec<8>::Zero()), again);
    EXPECT_LE((again - e.hess).norm(), 64 * kEpsilon * e.hess.norm());
  }
  EXPECT_EQ(guarded(segment(0.06 * kLength, kLength), nullptr, nullptr),
            stretch_energy(kStiffness, segment(0.06 * kLength, kLength), nullptr, nullptr));
  const Evaluated<8> point(guarded, segment(0.0, kLength));
  EXPECT_EQ(point.V, std::numeric_limits<double>::infinity());
  EXPECT_EQ(point.g, (Vec<8>::Zero()));
}

TEST_F(ElementStretch, StressFollowsTheCrush) {
  const Guarded guarded;
  const Vec<8> q = segment(0.03 * kLength, kLength), dq = segment(1e-7 * kLength, 0.0);
  const double here = guarded.term().stress(0, q, Vec<8>::Zero());
  EXPECT_NEAR(guarded.term().stress(0, q, dq) - here, guarded.term().stress(0, q + dq, Vec<8>::Zero()) - here,
              1e-4 * std::abs(guarded.term().stress(0, q, dq) - here));
}

TEST_F(ElementStretch, WithoutTensionHasNoForceAndAConvexHessian) {
  Vec<8> q = Vec<8>::Zero();
  q[4] = q[7] = kLength;
  const Evaluated<8> none(stretch, q);
  EXPECT_EQ(none.V, 0.0);
  EXPECT_EQ(none.g, (Vec<8>::Zero()));
  for (const double strain : {-1e-9, -1e-12, 1e-12, 1e-9}) {  // and nothing jumps there
    const Evaluated<8> e(stretch, segment(kLength * (1.0 + strain), kLength));
    EXPECT_LE(std::abs(e.g[7] + kStiffness * strain), 1e-3 * kStiffness * std::abs(strain));
    EXPECT_LE((e.hess - Evaluated<8>(stretch, segment(kLength, kLength)).hess).norm(),
              16 * (std::abs(strain) + kEpsilon) * kStiffness / kLength);
  }
  Vec<8> slope = Vec<8>::Zero();
  slope[0] = slope[7] = -1.0;
  slope[3] = slope[4] = 1.0;
  EXPECT_EQ(none.hess, Mat<8>(kStiffness / kLength * slope * slope.transpose()));
}

}  // namespace
}  // namespace slipstitch::testing
