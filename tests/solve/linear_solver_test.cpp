// SPDX-License-Identifier: MIT
#include "solve/linear_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dense_matrix.h"

namespace slipstitch::testing {
namespace {

/// Second differences around a ring; definite for shift > 0.
Eigen::MatrixXd ring(int n, double shift) {
  Eigen::MatrixXd a = (2.0 + shift) * Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i < n; ++i) a(i, (i + 1) % n) = a((i + 1) % n, i) = -1.0;
  return a;
}

std::shared_ptr<const SparsePattern> ring_pattern(int n) {
  std::vector<std::vector<int>> cliques;
  for (int i = 0; i < n; ++i) cliques.push_back({i, (i + 1) % n});
  return make_pattern(n, cliques);
}

TEST(Cholmod, SolvesADefiniteSystem) {
  constexpr int n = 50;
  const SparseMatrix a = sparse(ring(n, 0.1), ring_pattern(n));
  VecX expected(n), b, x;
  for (int i = 0; i < n; ++i) expected[i] = std::sin(1.0 + 7.0 * i);
  multiply(a, expected, b);
  const auto solver = make_cholmod_solver();
  ASSERT_EQ(solver->factor(a), LinearStatus::ok);
  ASSERT_EQ(solver->solve(b, x), LinearStatus::ok);
  EXPECT_LT((x - expected).norm(), 1e-12);
}

TEST(Cholmod, SaysThatAnIndefiniteMatrixIsNotDefinite) {
  const auto pattern = ring_pattern(50);
  const auto solver = make_cholmod_solver();
  EXPECT_EQ(solver->factor(sparse(ring(50, -0.1), pattern)), LinearStatus::not_positive_definite);
  EXPECT_EQ(solver->factor(sparse(ring(50, -5.0), pattern)), LinearStatus::not_positive_definite);
  Eigen::MatrixXd saddle = Eigen::MatrixXd::Identity(3, 3);  // fails at the last pivot only
  saddle(2, 2) = -1e-3;
  EXPECT_EQ(make_cholmod_solver()->factor(sparse(saddle, full_pattern(3))), LinearStatus::not_positive_definite);
}

TEST(Cholmod, RecoversWithTheSamePatternAfterAnIndefiniteMatrix) {
  constexpr int n = 50;
  const auto pattern = ring_pattern(n);
  const auto solver = make_cholmod_solver();
  ASSERT_EQ(solver->factor(sparse(ring(n, -0.1), pattern)), LinearStatus::not_positive_definite);
  const SparseMatrix a = sparse(ring(n, 0.3), pattern);
  VecX x, back;
  const VecX b = VecX::LinSpaced(n, -1.0, 2.0);
  ASSERT_EQ(solver->factor(a), LinearStatus::ok);
  ASSERT_EQ(solver->solve(b, x), LinearStatus::ok);
  multiply(a, x, back);
  EXPECT_LT((back - b).norm(), 1e-12);
}

TEST(Cholmod, TakesAnotherPattern) {
  const auto solver = make_cholmod_solver();
  for (const int n : {5, 9, 3}) {
    const SparseMatrix a = sparse(ring(n, 1.0), ring_pattern(n));
    VecX x, back;
    const VecX b = VecX::Ones(n);
    ASSERT_EQ(solver->factor(a), LinearStatus::ok);
    ASSERT_EQ(solver->solve(b, x), LinearStatus::ok);
    multiply(a, x, back);
    EXPECT_LT((back - b).norm(), 1e-13) << n;
  }
}

TEST(Cholmod, TakesAnotherPatternOfTheSameSizeWhetherItsOrderStillFitsOrNot) {
  constexpr int n = 12;
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  const auto ring_only = ring_pattern(n), full = make_pattern(n, std::vector<std::vector<int>>{all});
  const auto chord = with_cliques(*ring_only, std::vector<std::vector<int>>{{2, 7}});
  Eigen::MatrixXd with_chord = ring(n, 1.0), filled = Eigen::MatrixXd::Constant(n, n, -0.05) + ring(n, 1.0);
  with_chord(2, 7) = with_chord(7, 2) = -0.5;
  const auto solver = make_cholmod_solver();
  for (const SparseMatrix& a : {sparse(ring(n, 1.0), ring_only), sparse(with_chord, chord), sparse(filled, full),
                                sparse(with_chord, chord), sparse(ring(n, 1.0), ring_only)}) {
    VecX x, back;
    const VecX b = VecX::LinSpaced(n, -1.0, 2.0);
    ASSERT_EQ(solver->factor(a), LinearStatus::ok);
    ASSERT_EQ(solver->solve(b, x), LinearStatus::ok);
    multiply(a, x, back);
    EXPECT_LT((back - b).norm(), 1e-12);
  }
}

TEST(Cholmod, RepeatsBitForBit) {
  constexpr int n = 200;
  const SparseMatrix a = sparse(ring(n, 0.01), ring_pattern(n));
  const VecX b = VecX::LinSpaced(n, 0.0, 1.0);
  VecX first, second;
  for (VecX* x : {&first, &second}) {
    const auto solver = make_cholmod_solver();
    ASSERT_EQ(solver->factor(a), LinearStatus::ok);
    ASSERT_EQ(solver->solve(b, *x), LinearStatus::ok);
  }
  EXPECT_TRUE((first.array() == second.array()).all());
}

}  // namespace
}  // namespace slipstitch::testing
