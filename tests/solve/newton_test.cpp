// SPDX-License-Identifier: MIT
#include "solve/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense_matrix.h"

namespace slipstitch::testing {
namespace {

/// A function given by lambdas, with a dense Hessian.
class Function : public Objective {
 public:
  explicit Function(int n) : pattern_(full_pattern(n)) {}
  double value(const VecX& x) override {
    ++values;
    return f(x);
  }
  double derivatives(const VecX& x, HessianMode, VecX& g, SparseMatrix& h) override {
    ++evaluations;
    g = gradient(x);
    h.pattern = pattern_;
    set_values(hessian(x), h);
    return f(x);
  }
  double max_step(const VecX& x, const VecX& dx) override { return limit ? limit(x, dx) : 1.0; }
  double value_scale() const override { return scale; }

  std::function<double(const VecX&)> f;
  std::function<VecX(const VecX&)> gradient;
  std::function<Eigen::MatrixXd(const VecX&)> hessian;
  std::function<double(const VecX&, const VecX&)> limit;
  double scale = 1.0;
  int values = 0, evaluations = 0;

 private:
  std::shared_ptr<const SparsePattern> pattern_;
};

/// 1/2 x^T A x - b^T x.
Function quadratic(const Eigen::MatrixXd& a, const VecX& b) {
  Function q(static_cast<int>(b.size()));
  q.f = [=](const VecX& x) { return 0.5 * x.dot(a * x) - b.dot(x); };
  q.gradient = [=](const VecX& x) -> VecX { return a * x - b; };
  q.hessian = [=](const VecX&) { return a; };
  return q;
}

/// (1 - x)^2 + 100 (y - x^2)^2, minimum at (1, 1), indefinite above the parabola.
Function rosenbrock() {
  Function r(2);
  r.f = [](const VecX& x) { return std::pow(1.0 - x[0], 2) + 100.0 * std::pow(x[1] - x[0] * x[0], 2); };
  r.gradient = [](const VecX& x) -> VecX {
    const double d = x[1] - x[0] * x[0];
    return Vec<2>(-2.0 * (1.0 - x[0]) - 400.0 * x[0] * d, 200.0 * d);
  };
  r.hessian = [](const VecX& x) -> Eigen::MatrixXd {
    Mat<2> h;
    h << 2.0 - 400.0 * (x[1] - 3.0 * x[0] * x[0]), -400.0 * x[0], -400.0 * x[0], 200.0;
    return h;
  };
  r.scale = 10.0;
  return r;
}

/// 1/4 (x^2 - 1)^2 + 1/2 y^2: minima at x = +-1, a saddle between them.
Function double_well() {
  Function d(2);
  d.f = [](const VecX& x) { return 0.25 * std::pow(x[0] * x[0] - 1.0, 2) + 0.5 * x[1] * x[1]; };
  d.gradient = [](const VecX& x) -> VecX { return Vec<2>(x[0] * (x[0] * x[0] - 1.0), x[1]); };
  d.hessian = [](const VecX& x) -> Eigen::MatrixXd {
    return Vec<2>(3.0 * x[0] * x[0] - 1.0, 1.0).asDiagonal().toDenseMatrix();
  };
  return d;
}

NewtonReport minimise(Objective& objective, const NewtonOptions& options, VecX& x) {
  const auto solver = make_cholmod_solver();
  return newton(objective, *solver, options, x);
}

NewtonOptions until_gradient(double tolerance) {
  NewtonOptions options;
  options.gradient_tolerance = tolerance;
  return options;
}

TEST(Newton, StallsAtOnceWhereNoStepIsAllowed) {
  Function bowl = quadratic(Mat<2>::Identity(), Vec<2>(1.0, 1.0));
  bowl.limit = [](const VecX&, const VecX&) { return 0.0; };
  const auto solver = make_cholmod_solver();
  VecX x = Vec<2>::Zero();
  NewtonOptions options;
  options.step_tolerance = 1e-9;
  const NewtonReport report = newton(bowl, *solver, options, x);
  EXPECT_EQ(report.status, NewtonStatus::stalled);
  EXPECT_EQ(report.iterations, 0);
}

TEST(Newton, SolvesAQuadraticInOneStep) {
  Mat<3> a;
  a << 4, 1, 0, 1, 3, -1, 0, -1, 2;
  const Vec3 b(1.0, -2.0, 0.5);
  Function q = quadratic(a, b);
  VecX x = Vec3(10.0, 20.0, -30.0);
  const NewtonReport report = minimise(q, until_gradient(1e-11), x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.factorizations, 1);
  EXPECT_LT((a * x - b).norm(), 1e-11);
}

TEST(Newton, AsksForNoMoreThanTheLastDigitsLetItKnow) {
  // A stiff spring between two unknowns far from zero: one digit of either is a force of 1e12 x 1e-13.
  Mat<2> a;
  a << 1e12 + 1.0, -1e12, -1e12, 1e12 + 1.0;
  const double far = 1000.0 / 3.0;
  Function q = quadratic(a, Vec<2>(far, far));
  q.f = [far](const VecX& x) { return 0.5e12 * std::pow(x[0] - x[1], 2) + 0.5 * (x - Vec<2>(far, far)).squaredNorm(); };
  q.gradient = [far](const VecX& x) -> VecX {
    const double spring = 1e12 * (x[0] - x[1]);
    return Vec<2>(spring + x[0] - far, -spring + x[1] - far);
  };
  VecX x = Vec<2>(far + 1.0, far - 1.0);
  const NewtonReport report = minimise(q, until_gradient(1e-9), x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_LT(report.iterations, 10);
  EXPECT_LT((x - Vec<2>(far, far)).norm(), 1e-4);  // a soft unknown is known as well as the stiff spring is
  VecX near = Vec<2>(1.0, -1.0);
  Function exact = quadratic(a, Vec<2>(0.0, 0.0));  // where every digit can be known it is asked for
  EXPECT_EQ(minimise(exact, until_gradient(1e-9), near).status, NewtonStatus::converged);
  EXPECT_LE(exact.gradient(near).cwiseAbs().maxCoeff(), 1e-9);
}

/// Records what Newton asks for; with the predicted stress wrong by `off`.
class Recorder final : public Objective {
 public:
  Recorder(Function inner, double off) : inner_(std::move(inner)), off_(off) {}
  double value(const VecX& x) override { return inner_.value(x); }
  double derivatives(const VecX& x, HessianMode mode, VecX& g, SparseMatrix& h) override {
    modes.push_back(mode);
    const double value = inner_.derivatives(x, mode, g, h);
    if (mode == HessianMode::predicted)
      for (int c = 0; c < h.pattern->n; ++c)
        h.values[static_cast<std::size_t>(h.pattern->column_first[static_cast<std::size_t>(c)])] += off_;
    return value;
  }
  double max_step(const VecX& x, const VecX& dx) override { return inner_.max_step(x, dx); }
  double value_scale() const override { return inner_.value_scale(); }
  void predict(const VecX& x, const VecX& dx) override { promised.push_back(x + dx); }

  std::vector<HessianMode> modes;
  std::vector<VecX> promised;

 private:
  Function inner_;
  double off_;
};

TEST(Newton, UsesThePredictedStressesAndSaysWhereItMoves) {
  Recorder r(quadratic(Mat3::Identity(), Vec3::Ones()), 0.0);
  VecX x = Vec3::Zero();
  EXPECT_EQ(minimise(r, until_gradient(1e-12), x).status, NewtonStatus::converged);
  EXPECT_EQ(r.modes, (std::vector{HessianMode::predicted, HessianMode::predicted}));
  ASSERT_EQ(r.promised.size(), 1U);
  EXPECT_LT((r.promised[0] - x).norm(), 1e-15);
}

TEST(Newton, GoesBackToTheExactHessianWhereThePredictedOneIsIndefinite) {
  Recorder r(quadratic(Mat3::Identity(), Vec3::Ones()), -2.0);
  VecX x = Vec3::Zero();
  const NewtonReport report = minimise(r, until_gradient(1e-12), x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_EQ(report.factorizations, 2);
  EXPECT_EQ(r.modes, (std::vector{HessianMode::predicted, HessianMode::exact, HessianMode::exact}));
}

TEST(Newton, TakesTheConvexPartWhereTheExactHessianIsIndefinite) {
  Recorder r(double_well(), 0.0);
  VecX x = Vec<2>(0.1, 2.0);
  EXPECT_EQ(minimise(r, until_gradient(1e-12), x).status, NewtonStatus::converged);
  ASSERT_GE(r.modes.size(), 3U);
  EXPECT_EQ(r.modes[1], HessianMode::exact);
  EXPECT_EQ(r.modes[2], HessianMode::convex);
}

TEST(Newton, KeepsItsFactorForTheLastSmallSteps) {
  Function r = rosenbrock();
  NewtonOptions options;
  options.step_tolerance = 1e-9;
  VecX x = Vec<2>(1.0 + 4e-9, 1.0 + 9e-9);
  const NewtonReport report = minimise(r, options, x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_EQ(report.factorizations, 1);
  EXPECT_GT(report.iterations, 1);
  EXPECT_GT(report.cg_iterations, 0);
  EXPECT_LT((x - Vec<2>(1.0, 1.0)).norm(), 1e-12);
}

TEST(Newton, StopsOnTheStepToo) {
  Function r = rosenbrock();
  NewtonOptions options;
  options.step_tolerance = 1e-2;
  VecX x = Vec<2>(-1.2, 1.0);
  const NewtonReport report = minimise(r, options, x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_LE(report.max_step, 1e-2);
  EXPECT_GT(report.max_gradient, 0.0);
  EXPECT_LT((x - Vec<2>(1.0, 1.0)).norm(), 1e-3);
}

TEST(Newton, ForeseesTheEndWhereStepsShrinkFast) {
  // cosh: from 0.5 the steps are 0.46, 0.038 and 1.8e-5.
  Function f(1);
  f.f = [](const VecX& x) { return std::cosh(x[0]); };
  f.gradient = [](const VecX& x) -> VecX { return VecX::Constant(1, std::sinh(x[0])); };
  f.hessian = [](const VecX& x) -> Eigen::MatrixXd { return Eigen::MatrixXd::Constant(1, 1, std::cosh(x[0])); };
  NewtonOptions options;
  options.step_tolerance = 5e-3;
  VecX x = VecX::Constant(1, 0.5);
  EXPECT_EQ(minimise(f, options, x).iterations, 3);
  options.foresee = true;
  x = VecX::Constant(1, 0.5);
  const NewtonReport report = minimise(f, options, x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_GT(report.max_step, options.step_tolerance);
  EXPECT_LT(std::abs(x[0]), options.step_tolerance);
  options.step_tolerance = 1e-3;  // 0.038^2 / (0.46 - 0.038) is more
  x = VecX::Constant(1, 0.5);
  EXPECT_EQ(minimise(f, options, x).iterations, 3);
}

TEST(Newton, ForeseesNothingWhereStepsShrinkSlowly) {
  Function f(1);  // x^4: every step leaves two thirds
  f.f = [](const VecX& x) { return std::pow(x[0], 4); };
  f.gradient = [](const VecX& x) -> VecX { return VecX::Constant(1, 4.0 * std::pow(x[0], 3)); };
  f.hessian = [](const VecX& x) -> Eigen::MatrixXd {
    return Eigen::MatrixXd::Constant(1, 1, 12.0 * x[0] * x[0]);
  };
  NewtonOptions options;
  options.step_tolerance = 1e-2;
  VecX x = VecX::Constant(1, 1.0);
  const int without = minimise(f, options, x).iterations;
  options.foresee = true;
  x = VecX::Constant(1, 1.0);
  EXPECT_EQ(minimise(f, options, x).iterations, without);
}

// Where every energy is zero a step far below the tolerance cannot lower the value any more.
TEST(Newton, AcceptsASmallStepThatRoundOffHides) {
  Function flat = quadratic(Mat3::Identity(), Vec3::Zero());
  flat.f = [](const VecX&) { return 0.0; };
  flat.scale = 0.0;
  NewtonOptions options;
  options.step_tolerance = 1e-10;
  VecX x = Vec3(1e-18, 0.0, -1e-18);
  EXPECT_EQ(minimise(flat, options, x).status, NewtonStatus::converged);
}

/// size (x^2/2 + |x - 0.3|), the kink rounded over a billionth, as where something light sticks. Newton's steps lead
/// from -1 to 1 and back.
Function kinked(double size) {
  constexpr double kRound = 1e-9;
  Function f(1);
  const auto over = [](const VecX& x) { return x[0] - 0.3; };
  f.f = [=](const VecX& x) {
    const double s = std::abs(over(x));
    return size * (0.5 * x[0] * x[0] + (s > kRound ? s - 0.5 * kRound : 0.5 * s * s / kRound));
  };
  f.gradient = [=](const VecX& x) -> VecX { return Vec<1>(size * (x[0] + std::clamp(over(x) / kRound, -1.0, 1.0))); };
  f.hessian = [=](const VecX& x) -> Eigen::MatrixXd {
    return Mat<1>(size * (std::abs(over(x)) > kRound ? 1.0 : 1.0 + 1.0 / kRound));
  };
  return f;
}

TEST(Newton, FindsAKinkThatItStepsOver) {
  for (const double size : {1.0, 1e-17}) {  // the second changes no digit of the value
    Function f = kinked(size);
    NewtonOptions options;
    options.step_tolerance = 1e-6;
    VecX x = Vec<1>(1.0);
    const NewtonReport report = minimise(f, options, x);
    EXPECT_EQ(report.status, NewtonStatus::converged) << size;
    EXPECT_LT(report.iterations, 40) << size;
    EXPECT_NEAR(x[0], 0.3, 1e-8) << size;
  }
}

TEST(Newton, LosesItsShiftTowardsTheEnd) {
  // A free unknown that next to nothing holds: the shift, five times that, would leave it 50 steps.
  Function q = quadratic(Vec<2>(1e9, 0.1).asDiagonal().toDenseMatrix(), Vec<2>(0.0, 1e-5));
  NewtonOptions options = until_gradient(1e-9);
  options.relative_shift = 1e-9;
  options.most_shift = Vec<2>(1.0, 1.0);
  VecX x = Vec<2>::Zero();
  const NewtonReport report = minimise(q, options, x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_LT(report.iterations, 15);
  EXPECT_NEAR(x[1], 1e-4, 1e-8);
}

TEST(Newton, FindsTheMinimumOfACurvedValley) {
  Function r = rosenbrock();
  VecX x = Vec<2>(-1.2, 1.0);
  const NewtonReport report = minimise(r, until_gradient(1e-10), x);
  EXPECT_EQ(report.status, NewtonStatus::converged);
  EXPECT_LT((x - Vec<2>(1.0, 1.0)).norm(), 1e-9);
}

TEST(Newton, LeavesAnIndefiniteStartForAMinimum) {
  for (const double start : {0.1, -0.1, 0.5}) {
    Function d = double_well();
    VecX x = Vec<2>(start, 2.0);
    const NewtonReport report = minimise(d, until_gradient(1e-12), x);
    EXPECT_EQ(report.status, NewtonStatus::converged) << start;
    EXPECT_GT(report.convex_hessians, 0) << start;
    EXPECT_NEAR(std::abs(x[0]), 1.0, 1e-11) << start;
    EXPECT_NEAR(x[1], 0.0, 1e-11) << start;
  }
}

// A full step over a ridge ends in a basin higher than the start. What is small there says nothing about where the
// search goes on after it has turned back.
TEST(Newton, DoesNotCallTheWayBackConverged) {
  Function f(1);
  f.f = [](const VecX& x) { return x[0] < 0.5 ? 0.5 * std::pow(x[0] - 0.3, 2) : 5.0 + 0.5 * std::pow(x[0] - 1.0, 2); };
  f.gradient = [](const VecX& x) -> VecX {
    if (x[0] < 0.5) return Vec<1>(x[0] - 0.3);
    return Vec<1>(x[0] - 1.0 + (x[0] < 1.0 ? -1e-14 : 1e-14));  // round-off that never vanishes
  };
  f.hessian = [](const VecX& x) -> Eigen::MatrixXd { return Mat<1>(x[0] == 0.0 ? 0.3 : 1.0); };
  NewtonOptions options;
  options.step_tolerance = 1e-10;
  VecX x = Vec<1>(0.0);
  EXPECT_EQ(minimise(f, options, x).status, NewtonStatus::converged);
  EXPECT_NEAR(x[0], 0.3, 1e-10);
}

TEST(Newton, TurnsBackFromATrialThatCannotBeFactored) {
  Function f(2);
  f.f = [](const VecX& x) { return x[0] < 0.5 ? 0.5 * (x - Vec<2>(0.3, 0.0)).squaredNorm() : 5.0; };
  f.gradient = [](const VecX& x) -> VecX { return x[0] < 0.5 ? Vec<2>(x - Vec<2>(0.3, 0.0)) : Vec<2>(1.0, 1.0); };
  f.hessian = [](const VecX& x) -> Eigen::MatrixXd {
    Mat<2> h = (x[0] == 0.0 ? 0.3 : 1.0) * Mat<2>::Identity();
    if (x[0] >= 0.5) h(0, 1) = h(1, 0) = 1000.0;  // indefinite beyond any shift tried
    return h;
  };
  VecX x = Vec<2>(0.0, 0.0);
  EXPECT_EQ(minimise(f, until_gradient(1e-12), x).status, NewtonStatus::converged);
  EXPECT_NEAR(x[0], 0.3, 1e-12);
}

TEST(Newton, NeverStepsPastTheLimit) {
  Function q = quadratic(Mat3::Identity(), Vec3(1.0, 0.0, 0.0));
  double farthest = 0.0;
  q.limit = [&](const VecX& x, const VecX& dx) { return x[0] + dx[0] > 0.5 ? (0.5 - x[0]) / dx[0] * 0.9 : 1.0; };
  q.f = [&, f = q.f](const VecX& x) {
    farthest = std::max(farthest, x[0]);
    return f(x);
  };
  VecX x = Vec3::Zero();
  const NewtonReport report = minimise(q, until_gradient(1e-10), x);
  EXPECT_NE(report.status, NewtonStatus::converged);
  EXPECT_LE(farthest, 0.5);
  EXPECT_NEAR(x[0], 0.5, 1e-6);
}

TEST(Newton, CancelsBeforeTheNextIteration) {
  Function r = rosenbrock();
  NewtonOptions options = until_gradient(1e-14);
  int polls = 0;
  options.should_stop = [&] { return ++polls > 3; };
  VecX x = Vec<2>(-1.2, 1.0);
  const NewtonReport report = minimise(r, options, x);
  EXPECT_EQ(report.status, NewtonStatus::cancelled);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_LE(r.evaluations, 3 + 2 * report.convex_hessians);
}

TEST(Newton, SaysWhenItRunsOutOfIterations) {
  Function r = rosenbrock();
  NewtonOptions options = until_gradient(1e-12);
  options.max_iterations = 2;
  VecX x = Vec<2>(-1.2, 1.0);
  EXPECT_EQ(minimise(r, options, x).status, NewtonStatus::too_many_iterations);
}

TEST(Newton, SaysWhenTheLineSearchFails) {
  Function wrong = quadratic(Mat3::Identity(), Vec3::Ones());
  wrong.gradient = [](const VecX& x) -> VecX { return Vec3::Ones() - x; };  // uphill
  VecX x = Vec3::Zero();
  EXPECT_EQ(minimise(wrong, until_gradient(1e-10), x).status, NewtonStatus::stalled);
  EXPECT_EQ(x, VecX(Vec3::Zero()));
}

TEST(Newton, SaysWhenTheValueIsNotFinite) {
  Function bad = quadratic(Mat3::Identity(), Vec3::Ones());
  bad.f = [](const VecX&) { return std::numeric_limits<double>::quiet_NaN(); };
  VecX x = Vec3::Zero();
  EXPECT_EQ(minimise(bad, until_gradient(1e-10), x).status, NewtonStatus::not_finite);
}

TEST(Newton, BacksOffFromWhereTheValueIsNotFinite) {
  Function log_barrier(1);  // x - log x, minimum at 1, infinite at and below 0
  log_barrier.f = [](const VecX& x) {
    return x[0] > 0.0 ? x[0] - std::log(x[0]) : std::numeric_limits<double>::infinity();
  };
  log_barrier.gradient = [](const VecX& x) -> VecX { return Vec<1>(1.0 - 1.0 / x[0]); };
  log_barrier.hessian = [](const VecX& x) -> Eigen::MatrixXd { return Mat<1>(1.0 / (x[0] * x[0])); };
  VecX x = Vec<1>(5.0);  // the full Newton step leads to -15
  EXPECT_EQ(minimise(log_barrier, until_gradient(1e-12), x).status, NewtonStatus::converged);
  EXPECT_NEAR(x[0], 1.0, 1e-12);
}

}  // namespace
}  // namespace slipstitch::testing
