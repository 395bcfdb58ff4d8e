// SPDX-License-Identifier: MIT
#include "force/stretch.h"

#include <algorithm>
#include <limits>

#include "force/segments.h"

namespace slipstitch {

double stretch_energy(double k_s, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) {
  const Vec3 d = q.segment<3>(4) - q.segment<3>(0);
  const double D = q[7] - q[3];
  if (!(D > 0.0)) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return std::numeric_limits<double>::infinity();
  }
  const double length = d.norm();
  const double strain = (length - D) / D;
  if (g || hess) {
    const double safe_length = std::max(length, 1e-12 * D);
    const Vec3 t = d / safe_length;
    const double lambda = length / D;
    if (g) {
      const double force = k_s * strain;
      const double arc_force = 0.5 * k_s * strain * (lambda + 1.0);
      *g << -force * t, arc_force, force * t, -arc_force;
    }
    if (hess) {
      Vec<8> a;
      a << -t, lambda, t, -lambda;
      hess->noalias() = (k_s / D * a) * a.transpose();
      const Mat3 turn = (k_s * strain / safe_length) * (Mat3::Identity() - t * t.transpose());
      hess->block<3, 3>(0, 0) += turn;
      hess->block<3, 3>(4, 4) += turn;
      hess->block<3, 3>(0, 4) -= turn;
      hess->block<3, 3>(4, 0) -= turn;
    }
  }
  return 0.5 * k_s * D * strain * strain;
}

void Stretch::convexify(int, const Vec<8>& q, Mat<8>& hess) const {
  const Vec3 d = q.segment<3>(4) - q.segment<3>(0);
  const double D = q[7] - q[3], length = d.norm();
  if (!(length < D) || !(length > 0.0)) return;
  const double lambda = length / D;
  Vec<8> a;
  a << -d / length, lambda, d / length, -lambda;
  hess.noalias() = (k_s_ / D * a) * a.transpose();
}

Stretch::Stretch(const Model& model) : k_s_(model.yarn.stretch_n) {
  if (!model.effects.stretch) return;
  for_each_owned_segment(model.topology, [&](int, int i) { coords_.push_back(segment_coords(model.topology, i)); });
}

}  // namespace slipstitch
