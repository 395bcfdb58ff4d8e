// SPDX-License-Identifier: MIT
#include "force/body_inertia.h"

namespace slipstitch {

BodyInertia::BodyInertia(const Model& model) {
  if (!model.effects.inertia) return;
  bodies_ = model.bodies;
  start_.resize(bodies_.size(), Vec3::Zero());
  start_momentum_.resize(bodies_.size(), Vec3::Zero());
}

void BodyInertia::begin_step(const StepContext& step) {
  h_ = step.h;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const int c = 3 * bodies_[i].node;
    start_[i] = step.sum(Vec3(Vec3::Zero()), [&](const Past& known) { return known.q->segment<3>(c); });
    start_momentum_[i] = step.sum(Vec3(Vec3::Zero()), [&](const Past& known) { return known.p->segment<3>(c); });
  }
}

double BodyInertia::eval(int k, const Vec<3>& q, Vec<3>* g, Mat<3>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  const double stiffness = bodies_[i].mass_kg / (h_ * h_);
  const Vec3 d = q - start_[i];
  if (g) *g = stiffness * d - start_momentum_[i] / h_;
  if (hess) *hess = stiffness * Mat3::Identity();
  return 0.5 * stiffness * d.squaredNorm() - d.dot(start_momentum_[i]) / h_;
}

void BodyInertia::put_momentum(const VecX& v, VecX& p) const {
  for (const Body& body : bodies_) p.segment<3>(3 * body.node) = body.mass_kg * v.segment<3>(3 * body.node);
}

double BodyInertia::kinetic_energy(const VecX& v) const {
  double energy = 0.0;
  for (const Body& body : bodies_) energy += 0.5 * body.mass_kg * v.segment<3>(3 * body.node).squaredNorm();
  return energy;
}

}  // namespace slipstitch
