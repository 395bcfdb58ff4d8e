// SPDX-License-Identifier: MIT
#include "force/kinetic.h"

namespace slipstitch {
namespace {

struct Motion {
  double D;
  Vec3 w, v0, v1;  // dx/du and the material velocities at both ends
  double udot0, udot1;

  Motion(const Vec<8>& q, const Vec<8>& qdot)
      : D(q[7] - q[3]), w((q.segment<3>(4) - q.segment<3>(0)) / D), udot0(qdot[3]), udot1(qdot[7]) {
    v0 = qdot.segment<3>(0) - w * udot0;
    v1 = qdot.segment<3>(4) - w * udot1;
  }
  double energy(double rho) const { return rho * D / 6.0 * (v0.dot(v0) + v0.dot(v1) + v1.dot(v1)); }
};

}  // namespace

double kinetic_energy(double rho, const Vec<8>& q, const Vec<8>& qdot) { return Motion(q, qdot).energy(rho); }

Mat<8> kinetic_mass(double rho, const Vec<8>& q) {
  const double D = q[7] - q[3];
  const Vec3 w = (q.segment<3>(4) - q.segment<3>(0)) / D;
  Mat<4> BtB = Mat<4>::Identity();  // B = [I, -w]
  BtB.block<3, 1>(0, 3) = -w;
  BtB.block<1, 3>(3, 0) = -w.transpose();
  BtB(3, 3) = w.squaredNorm();
  BtB *= rho * D / 6.0;
  Mat<8> M;
  M << 2.0 * BtB, BtB, BtB, 2.0 * BtB;
  return M;
}

Vec<8> kinetic_gradient(double rho, const Vec<8>& q, const Vec<8>& qdot) {
  const Motion m(q, qdot);
  const Vec3 dT_dw = -(rho * m.D / 6.0) * ((2.0 * m.v0 + m.v1) * m.udot0 + (m.v0 + 2.0 * m.v1) * m.udot1);
  const Vec3 dx = dT_dw / m.D;
  const double du = (m.energy(rho) - m.w.dot(dT_dw)) / m.D;
  Vec<8> g;
  g << -dx, -du, dx, du;
  return g;
}

Vec<8> kinetic_mass_rate(double rho, const Vec<8>& q, const Vec<8>& qdot) {
  const Motion m(q, qdot);
  const double Ddot = m.udot1 - m.udot0;
  const Vec3 wdot = (qdot.segment<3>(4) - qdot.segment<3>(0) - m.w * Ddot) / m.D;
  // d/dt (D B^T B) acting on one end's velocity
  const auto end = [&](const Vec3& v, double udot) {
    const Vec3 x = Ddot * v - (m.D * udot) * wdot;
    Vec<4> r;
    r << x, -m.w.dot(x) - m.D * wdot.dot(v);
    return r;
  };
  const Vec<4> r0 = end(m.v0, m.udot0), r1 = end(m.v1, m.udot1);
  Vec<8> rate;
  rate << rho / 6.0 * (2.0 * r0 + r1), rho / 6.0 * (r0 + 2.0 * r1);
  return rate;
}

}  // namespace slipstitch
