// SPDX-License-Identifier: MIT
#include "force/body_gravity.h"

namespace slipstitch {

BodyGravity::BodyGravity(const Model& model) {
  if (!model.effects.gravity) return;
  acceleration_ = model.effects.gravity->acceleration_m_per_s2;
  bodies_ = model.bodies;
}

double BodyGravity::eval(int k, const Vec<3>& q, Vec<3>* g, Mat<3>* hess) const {
  const Vec3 weight = bodies_[static_cast<std::size_t>(k)].mass_kg * acceleration_;
  if (g) *g = -weight;
  if (hess) hess->setZero();
  return -weight.dot(q);
}

}  // namespace slipstitch
