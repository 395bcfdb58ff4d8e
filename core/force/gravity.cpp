// SPDX-License-Identifier: MIT
#include "force/gravity.h"

#include "force/segments.h"

namespace slipstitch {

double gravity_energy(double rho, const Vec3& acceleration, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) {
  const double D = q[7] - q[3];
  const double height = 0.5 * acceleration.dot(q.segment<3>(0) + q.segment<3>(4));  // g . midpoint
  if (g) {
    const Vec3 half_weight = (0.5 * rho * D) * acceleration;
    *g << -half_weight, rho * height, -half_weight, -rho * height;
  }
  if (hess) {
    const Vec3 per_arc = (0.5 * rho) * acceleration;
    hess->setZero();
    for (int x : {0, 4}) {
      hess->block<3, 1>(x, 3) = per_arc;
      hess->block<3, 1>(x, 7) = -per_arc;
      hess->block<1, 3>(3, x) = per_arc.transpose();
      hess->block<1, 3>(7, x) = -per_arc.transpose();
    }
  }
  return -rho * D * height;
}

Gravity::Gravity(const Model& model) {
  if (!model.effects.gravity) return;
  acceleration_ = model.effects.gravity->acceleration_m_per_s2;
  for_each_owned_segment(model.topology, [&](int yarn, int i) {
    coords_.push_back(segment_coords(model.topology, i));
    rho_.push_back(linear_density(model, yarn));
  });
}

}  // namespace slipstitch
