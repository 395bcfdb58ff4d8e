// SPDX-License-Identifier: MIT
#include "solve/conjugate_gradients.h"

#include <gtest/gtest.h>

#include "dense_matrix.h"

namespace slipstitch::testing {
namespace {

SparseMatrix matrix(const Eigen::MatrixXd& dense) {
  SparseMatrix a;
  a.pattern = full_pattern(static_cast<int>(dense.rows()));
  set_values(dense, a);
  return a;
}

std::unique_ptr<LinearSolver> factored(const Eigen::MatrixXd& dense) {
  auto solver = make_cholmod_solver();
  EXPECT_EQ(solver->factor(matrix(dense)), LinearStatus::ok);
  return solver;
}

Eigen::MatrixXd definite() {
  Mat<4> a;
  a << 4, 1, 0, 0, 1, 5, -2, 0, 0, -2, 6, 1, 0, 0, 1, 3;
  return a;
}

const Vec<4> kB(1.0, -2.0, 0.5, 3.0);

TEST(ConjugateGradients, SolvesInOneIterationWithTheMatrixsOwnFactor) {
  VecX x;
  const auto solver = factored(definite());
  const CgReport report = conjugate_gradients(matrix(definite()), *solver, kB, 1e-10, 10, x);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_LT((definite() * x - kB).norm(), 1e-14);
}

TEST(ConjugateGradients, SolvesInAsManyIterationsAsUnknownsWithAnother) {
  VecX x;
  const auto solver = factored(Mat<4>::Identity());
  const CgReport report = conjugate_gradients(matrix(definite()), *solver, kB, 1e-12, 10, x);
  EXPECT_TRUE(report.converged);
  EXPECT_LE(report.iterations, 4);
  EXPECT_GT(report.iterations, 1);
  EXPECT_LT((definite() * x - kB).norm(), 1e-12);
}

TEST(ConjugateGradients, StopsDownhillAtNegativeCurvature) {
  Eigen::MatrixXd a = definite();
  a(2, 2) = -6.0;
  for (const Vec<4>& b : {kB, Vec<4>(0.0, 0.0, 1.0, 0.0)}) {  // found late, and in the first direction
    VecX x;
    const auto solver = factored(Mat<4>::Identity());
    const CgReport report = conjugate_gradients(matrix(a), *solver, b, 1e-12, 10, x);
    EXPECT_TRUE(report.negative_curvature);
    EXPECT_FALSE(report.converged);
    EXPECT_GT(b.dot(x), 0.0);
  }
}

TEST(ConjugateGradients, SaysWhenTheIterationsRunOut) {
  VecX x;
  const auto solver = factored(Mat<4>::Identity());
  const CgReport report = conjugate_gradients(matrix(definite()), *solver, kB, 1e-12, 2, x);
  EXPECT_FALSE(report.converged);
  EXPECT_EQ(report.iterations, 2);
}

TEST(ConjugateGradients, NothingToSolveIsSolved) {
  VecX x;
  const auto solver = factored(definite());
  EXPECT_TRUE(conjugate_gradients(matrix(definite()), *solver, VecX::Zero(4), 1e-3, 10, x).converged);
  EXPECT_EQ(x, VecX(VecX::Zero(4)));
}

}  // namespace
}  // namespace slipstitch::testing
