// SPDX-License-Identifier: MIT
// What every term in the list must satisfy, whatever it models.
#include <Eigen/Eigenvalues>

#include "difference_check.h"
#include "terms_under_test.h"

namespace slipstitch::testing {
namespace {

template <class T>
class EveryTerm : public ::testing::Test {};
TYPED_TEST_SUITE(EveryTerm, Terms, TermNames);

TYPED_TEST(EveryTerm, IsEmptyWhenItsEffectIsOffAndOnlyThen) {
  EXPECT_EQ(TypeParam(everything_off()).size(), 0);
  const Model on = everything_on();
  EXPECT_GT(TypeParam(on).size(), 0);
}

TYPED_TEST(EveryTerm, DerivativesAreExact) {
  for_each_sample<TypeParam>([](const Sample& s) { expect_exact_derivatives(s.q, s.step, s.order, s.energy); });
}

void expect_symmetric(const Sample& s) {
  MatX hess;
  s.energy(s.q, nullptr, &hess);
  EXPECT_LE((hess - hess.transpose()).norm(), 4 * kEpsilon * hess.norm());
}

TYPED_TEST(EveryTerm, HessianIsSymmetric) { for_each_sample<TypeParam>(expect_symmetric); }

void expect_same_values_alone(const Sample& s) {
  VecX g, g_alone;
  MatX hess, hess_alone;
  const double V = s.energy(s.q, &g, &hess);
  EXPECT_EQ(V, s.energy(s.q, nullptr, nullptr));
  EXPECT_EQ(V, s.energy(s.q, &g_alone, nullptr));
  EXPECT_EQ(V, s.energy(s.q, nullptr, &hess_alone));
  EXPECT_EQ(g, g_alone);
  EXPECT_EQ(hess, hess_alone);
}

TYPED_TEST(EveryTerm, ValuesDoNotDependOnWhatElseIsAsked) { for_each_sample<TypeParam>(expect_same_values_alone); }

VecX eigenvalues(const MatX& m) { return Eigen::SelfAdjointEigenSolver<MatX>(m).eigenvalues(); }

void expect_projected(const Sample& s) {
  MatX hess;
  s.energy(s.q, nullptr, &hess);
  MatX projected = hess;
  const bool changed = s.project(projected);
  const MatX added = projected - hess;
  const VecX exact = eigenvalues(hess);
  const double round_off = 16 * static_cast<double>(s.q.size()) * kEpsilon * hess.norm();
  EXPECT_GE(eigenvalues(projected)[0], -round_off);
  EXPECT_GE(eigenvalues(added)[0], -round_off);
  EXPECT_NEAR(added.norm(), exact.cwiseMin(0.0).norm(), round_off);  // no more than the negative part
  EXPECT_EQ(changed, added.norm() > 0.0);
  if (exact[0] < -round_off) {
    EXPECT_TRUE(changed);
  }
}

TYPED_TEST(EveryTerm, ProjectedHessianIsTheNearestSemidefiniteOne) { for_each_sample<TypeParam>(expect_projected); }

}  // namespace
}  // namespace slipstitch::testing
