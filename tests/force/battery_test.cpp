// SPDX-License-Identifier: MIT
// What every term in the list must satisfy, whatever it models.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "difference_check.h"
#include "model/effect_list.h"
#include "terms_under_test.h"

namespace slipstitch::testing {
namespace {

template <class T>
class EveryTerm : public ::testing::Test {};
TYPED_TEST_SUITE(EveryTerm, Terms, TermNames);

/// Effects that a term acts for: all of them, else it has nothing to do.
std::vector<std::string> effects_of(const std::string& term) {
  static const std::map<std::string, std::vector<std::string>> others{{"dead_load", {}},
                                                                      {"collider_friction", {"colliders"}},
                                                                      {"body_contact", {"colliders"}},
                                                                      {"body_friction", {"colliders"}},
                                                                      {"body_inertia", {"colliders", "inertia"}},
                                                                      {"body_gravity", {"colliders", "gravity"}},
                                                                      {"damping_stretch", {"damping"}},
                                                                      {"damping_bending", {"damping"}},
                                                                      {"damping_wrapping", {"damping", "wrapping"}},
                                                                      {"damping_sliding", {"damping", "sliding"}}};
  const auto found = others.find(term);
  return found == others.end() ? std::vector<std::string>{term} : found->second;
}

template <class Term>
int stencils(const Model& model) {
  std::mt19937_64 random(7);
  const State start = state_at(model, model.start_q, random);
  Term term(model);
  term.begin_step(StepContext{1e-3, start});
  return term.size();
}

TYPED_TEST(EveryTerm, IsEmptyWhenItsEffectIsOffAndOnlyThen) {
  EXPECT_EQ(stencils<TypeParam>(everything_off()), 0);
  EXPECT_GT(stencils<TypeParam>(everything_on()), 0);
  const std::vector<std::string> needed = effects_of(std::string(TypeParam::kName));
  for (const EffectEntry& effect : effect_list()) {
    Effects others = all_effects();
    remove_effect(others, effect);
    const bool acts = std::all_of(needed.begin(), needed.end(),
                                  [&](const std::string& name) { return find_effect(name)->listed(others); });
    EXPECT_EQ(stencils<TypeParam>(loaded(others)) > 0, acts) << "without " << effect.name;
  }
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

void expect_convex(const Sample& s) {
  MatX hess;
  s.convex_hessian(s.q, hess);
  EXPECT_LE((hess - hess.transpose()).norm(), 4 * kEpsilon * hess.norm());
  EXPECT_GE(eigenvalues(hess)[0], -16 * static_cast<double>(s.q.size()) * kEpsilon * hess.norm());
}

TYPED_TEST(EveryTerm, ConvexHessianIsNeverIndefinite) { for_each_sample<TypeParam>(expect_convex); }

void expect_consistent_stress(const Sample& s) {
  if (!s.stress) return;
  const VecX none = VecX::Zero(s.q.size());
  MatX exact, at_stress;
  s.energy(s.q, nullptr, &exact);
  s.hessian_at(s.q, s.stress(s.q, none), at_stress);
  EXPECT_LE((at_stress - exact).norm(), 64 * kEpsilon * exact.norm());
  const VecX dq = VecX::Constant(s.q.size(), 1.0).cwiseProduct(VecX::LinSpaced(s.q.size(), -1e-7, 2e-7));
  const double slope = (s.stress(s.q + dq, none) - s.stress(s.q - dq, none)) / 2.0;
  EXPECT_NEAR(s.stress(s.q, dq) - s.stress(s.q, none), slope, 1e-4 * std::abs(slope) + 1e-9);
}

TYPED_TEST(EveryTerm, StressIsWhatTheHessianHoldsAndExtrapolatesLinearly) {
  for_each_sample<TypeParam>(expect_consistent_stress);
}

}  // namespace
}  // namespace slipstitch::testing
