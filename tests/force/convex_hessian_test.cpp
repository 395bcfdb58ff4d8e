// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "force/bending.h"
#include "force/damping.h"
#include "force/stretch.h"
#include "force/wrap_angle.h"
#include "force/wrapping.h"
#include "sample_models.h"

namespace slipstitch::testing {
namespace {

// Without stress nothing can be negative: the convex Hessian is the exact one.
template <class Term>
void expect_exact(const Term& term, int k, const Vec<Term::kSize>& q) {
  Mat<Term::kSize> exact, convex;
  term.eval(k, q, nullptr, &exact);
  term.convex_hessian(k, q, convex);
  EXPECT_GT(exact.norm(), 0.0);
  EXPECT_LE((convex - exact).norm(), 1e-9 * exact.norm()) << Term::kName << " " << k;
}

template <class Term>
Vec<Term::kSize> gather(const Term& term, int k, const VecX& q) {
  Vec<Term::kSize> x;
  for (int i = 0; i < Term::kSize; ++i) x[i] = q[term.coords(k)[static_cast<std::size_t>(i)]];
  return x;
}

template <class Term>
void expect_exact_where_nothing_has_moved() {
  const Model model = everything_on();
  std::mt19937_64 random(7);
  const State start = state_at(model, model.start_q, random);
  Term term(model);
  term.begin_step(StepContext{1e-3, start});
  ASSERT_GT(term.size(), 0);
  for (int k = 0; k < term.size(); ++k) expect_exact(term, k, gather(term, k, start.q));
}

TEST(ConvexHessian, OfDampingIsExactWhereNothingHasMoved) {
  expect_exact_where_nothing_has_moved<DampingStretch>();
  expect_exact_where_nothing_has_moved<DampingBending>();
  expect_exact_where_nothing_has_moved<DampingWrapping>();
}

TEST(ConvexHessian, OfStretchIsExactInTension) {
  const Model model = everything_on();
  const Stretch term(model);
  VecX q = model.start_q;
  q.tail(model.topology.num_visits()) *= 0.95;
  for (int k = 0; k < term.size(); ++k) expect_exact(term, k, gather(term, k, q));
}

TEST(ConvexHessian, OfBendingIsExactAlongStraightYarn) {
  const Bending term(everything_on());
  Vec<11> q;
  q << -0.3e-3, 0.4e-3, 0.0, 1e-3, 0.0, 0.0, 0.0, 0.6e-3, -0.8e-3, 0.0, 2.5e-3;
  expect_exact(term, 0, q);
}

TEST(ConvexHessian, OfWrappingIsExactAtItsRestAngle) {
  Model model = everything_on();
  int at_rest = 0;
  for (int k = 0; k < Wrapping(model).size(); ++k) {
    const auto q = gather(Wrapping(model), k, model.start_q);
    const double psi = wrap_angle(q.segment<3>(0), q.segment<3>(3), q.segment<3>(6), q.segment<3>(9));
    model.effects.wrapping->rest_angle_rad = std::abs(psi);
    const Wrapping term(model);
    Vec<12> force;
    term.eval(k, q, &force, nullptr);
    if (force.norm() > 1e-12 * model.yarn.bending_nm2 / 1e-6) continue;  // turned the other way, or faded
    expect_exact(term, k, q);
    ++at_rest;
  }
  EXPECT_GT(at_rest, 0);
}

}  // namespace
}  // namespace slipstitch::testing
