// SPDX-License-Identifier: MIT
// Identities that hold exactly for the signed wrap angle in every pose, stressed or not.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "force/wrapping.h"
#include "wrap_samples.h"

namespace slipstitch::testing {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kStiffness = 4.5e-8 / 1e-3;  // EI/L^2 * L [N m]
constexpr double kRest = kPi / 2;
constexpr double kLength = 1e-3;  // of every axis

struct Wrap {
  Vec<12> q, F;
  Mat<12> J;     // dF/dx
  double noise;  // rounding of F where coordinates are rounded

  explicit Wrap(const Vec<12>& at) : q(at) {
    bare_wrapping_energy(kStiffness, kRest, q, &F, &J);
    F = -F;
    J = -J;
    noise = 100 * kEps * (F.norm() + J.norm() * q.norm());
  }
  Vec3 axis() const { return (node(q, 1) - node(q, 0)).normalized(); }
  double length() const { return (node(q, 1) - node(q, 0)).norm(); }
};

double angle_of(const Vec<12>& q) { return wrap_angle(node(q, 0), node(q, 1), node(q, 2), node(q, 3)); }

TEST(WrappingIdentities, ForcesAndTorquesSumToZero) {
  for (const Vec<12>& q : random_hinges()) {
    const Wrap w(q);
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int n = 0; n < 4; ++n) {
      force += node(w.F, n);
      torque += node(w.q, n).cross(node(w.F, n));
    }
    EXPECT_LE(force.norm(), w.noise);
    EXPECT_LE(torque.norm(), w.noise * q.norm());
  }
}

TEST(WrappingIdentities, NoForceAlongTheAxisNorTowardsTheOrigin) {
  for (const Vec<12>& q : random_hinges()) {
    const Wrap w(q);
    for (int n = 0; n < 4; ++n) EXPECT_LE(std::abs(w.axis().dot(node(w.F, n))), w.noise);
    EXPECT_LE(std::abs(q.dot(w.F)), w.noise * q.norm());
  }
}

TEST(WrappingIdentities, JacobianKnowsTranslationScaleRotationAndStretchAlongTheAxis) {
  for (const Vec<12>& q : random_hinges()) {
    const Wrap w(q);
    const double noise = w.noise;
    const Vec3 turn(0.3, -0.5, 0.8);
    const Vec<12> translation = each_node(q, [](const Vec3&) { return Vec3(1e-3, 2e-3, -1e-3); });
    const Vec<12> spin = each_node(q, [&](const Vec3& x) { return Vec3(turn.cross(x)); });
    const Vec<12> spun_force = each_node(w.F, [&](const Vec3& f) { return Vec3(turn.cross(f)); });
    const Vec<12> along = each_node(q, [&](const Vec3& x) { return Vec3(w.axis() * w.axis().dot(x)); });
    EXPECT_LE((w.J - w.J.transpose()).norm(), 4 * kEps * w.J.norm());
    EXPECT_LE((w.J * translation).norm(), noise);
    EXPECT_LE((w.J * q + w.F).norm(), noise);
    EXPECT_LE((w.J * spin - spun_force).norm(), noise);
    EXPECT_LE((w.J * along).norm(), noise);
  }
}

TEST(WrappingIdentities, HessianHasFourPositiveFourNegativeFourZeroEigenvalues) {
  for (const Vec<12>& q : random_hinges()) {
    const Wrap w(q);
    Mat<12> angle_hessian;
    wrap_angle_derivatives(q, nullptr, &angle_hessian);
    for (const Mat<12>& h : {Mat<12>(-w.J), angle_hessian}) {
      const Vec<12> l = Eigen::SelfAdjointEigenSolver<Mat<12>>(h).eigenvalues();
      const double zero = 100 * kEps * l.cwiseAbs().maxCoeff();
      EXPECT_EQ((l.array() < -zero).count(), 4);
      EXPECT_EQ((l.array() > zero).count(), 4);
    }
  }
}

TEST(WrappingIdentities, RelabellingBothPairsKeepsTheAngleOneFlipsIt) {
  for (const Vec<12>& q : random_hinges()) {
    const double psi = angle_of(q);
    const double noise = 1e3 * kEps;
    const Vec3 x0 = node(q, 0), x1 = node(q, 1), x3 = node(q, 2), x4 = node(q, 3);
    EXPECT_NEAR(wrap_angle(x1, x0, x4, x3), psi, noise);
    EXPECT_NEAR(wrap_angle(x1, x0, x3, x4), -psi, noise);
    EXPECT_NEAR(wrap_angle(x0, x1, x4, x3), -psi, noise);
    const Vec<12> mirrored = each_node(q, [](const Vec3& x) { return Vec3(x.x(), x.y(), -x.z()); });
    EXPECT_NEAR(angle_of(mirrored), -psi, noise);
  }
}

TEST(WrappingIdentities, SignFollowsTheStitch) {
  const Vec3 x0(0, 0, 0), x1(1, 0, 0), x4(0, 1, 0);
  EXPECT_DOUBLE_EQ(wrap_angle(x0, x1, Vec3(0, 0, -1), x4), kPi / 2);
  EXPECT_DOUBLE_EQ(wrap_angle(x0, x1, Vec3(0, 0, 1), x4), -kPi / 2);
  EXPECT_DOUBLE_EQ(wrap_angle(x0, x1, Vec3(0, -1, 0), x4), 0.0);
  EXPECT_DOUBLE_EQ(std::abs(wrap_angle(x0, x1, Vec3(0, 1, 0), x4)), kPi);
}

TEST(WrappingIdentities, TheEnergyInUseIsTheBareOneWhereNothingFades) {
  int compared = 0;
  for (const Vec<12>& q : random_hinges()) {
    const double t = wrap_excess(angle_of(q), kRest);
    if (wrap_fade(q, kLength) < 1.0 || wrap_in_cap(t)) continue;
    if (std::abs(angle_of(q) - kRest) > kPi) continue;  // there the bare energy is on another branch
    ++compared;
    Vec<12> g, bare_g;
    Mat<12> hess, bare_hess;
    EXPECT_DOUBLE_EQ(wrapping_energy({kStiffness, kRest, kLength}, 0.0, q, &g, &hess),
                     bare_wrapping_energy(kStiffness, kRest, q, &bare_g, &bare_hess));
    EXPECT_EQ(g, bare_g);
    EXPECT_LE((hess - bare_hess).norm(), 4 * kEps * bare_hess.norm());
  }
  EXPECT_GT(compared, kNumHinges / 4);
}

}  // namespace
}  // namespace slipstitch::testing
