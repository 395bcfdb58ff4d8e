// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "force/damping.h"
#include "sample_models.h"

namespace slipstitch::testing {
namespace {

// Without stress nothing can be negative: the convex Hessian is the exact one.
template <class Term>
void expect_exact_where_nothing_has_moved() {
  const Model model = everything_on();
  std::mt19937_64 random(7);
  const State start = state_at(model, model.start_q, random);
  Term term(model);
  term.begin_step(StepContext{1e-3, start});
  ASSERT_GT(term.size(), 0);
  for (int k = 0; k < term.size(); ++k) {
    Vec<Term::kSize> q;
    for (int i = 0; i < Term::kSize; ++i) q[i] = start.q[term.coords(k)[static_cast<std::size_t>(i)]];
    Mat<Term::kSize> exact, convex;
    term.eval(k, q, nullptr, &exact);
    term.convex_hessian(k, q, convex);
    EXPECT_GT(exact.norm(), 0.0);
    EXPECT_LE((convex - exact).norm(), 1e-9 * exact.norm()) << Term::kName << " " << k;
  }
}

TEST(ConvexHessian, OfDampingIsExactWhereNothingHasMoved) {
  expect_exact_where_nothing_has_moved<DampingStretch>();
  expect_exact_where_nothing_has_moved<DampingBending>();
  expect_exact_where_nothing_has_moved<DampingWrapping>();
}

}  // namespace
}  // namespace slipstitch::testing
