// SPDX-License-Identifier: MIT
#include "force/bending.h"

#include <limits>

#include "force/bend_geometry.h"
#include "force/plasticity.h"
#include "force/segments.h"

namespace slipstitch {
double bending_energy(double k_b, const Vec<11>& q, Vec<11>* g, Mat<11>* hess) {
  const double W = bend_arc(q);
  if (!(W > 0.0)) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return std::numeric_limits<double>::infinity();
  }
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta();
  const double k = k_b / W;
  BendFunction f;
  f.value = k * theta * theta;
  if (g || hess) {
    const SquaredAngle phi = squared_angle(cosine, theta);
    f.c = k * phi.c;
    f.cc = k * phi.cc;
    f.W = -f.value / W;
    f.cW = -f.c / W;
    f.WW = 2.0 * f.value / (W * W);
    bend_derivatives(f, cosine, g, hess);
  }
  return f.value;
}

double Bending::eval(int k, const Vec<11>& q, Vec<11>* g, Mat<11>* hess) const {
  if (set_.empty()) return bending_energy(k_b_, q, g, hess);
  return set_bending_energy(k_b_, set_[static_cast<std::size_t>(k)], q, g, hess);
}

void Bending::convex_hessian(int k, const Vec<11>& q, Mat<11>& hess) const {
  if (!set_.empty()) return convex_set_bending(k_b_, set_[static_cast<std::size_t>(k)], q, hess);
  const double W = bend_arc(q), stiffness = 2.0 * k_b_ / W;
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta();
  convex_bend_hessian({stiffness, stiffness * theta, theta / W}, cosine, theta, hess);
}

Bending::Bending(const Model& model) : k_b_(model.yarn.bending_nm2) {
  if (!model.effects.bending) return;
  for_each_owned_bend(model.topology, [&](int, int i) { coords_.push_back(bend_coords(model.topology, i)); });
  plasticity_ = model.effects.plasticity;
  first_arc_coord_ = model.topology.arc_coord(0);
  if (plasticity_) set_.resize(coords_.size());
}

void Bending::begin_step(const StepContext& step) {
  for (std::size_t k = 0; k < set_.size(); ++k) set_[k] = step.start.set_angle[visit(static_cast<int>(k))];
}

void Bending::creep(double h, const VecX& q, VecX& set_angle) const {
  for (std::size_t k = 0; k < set_.size(); ++k) {
    const auto x = [&](std::size_t first) { return Vec3(q.segment<3>(coords_[k][first])); };
    const double theta = Cosine(x(4) - x(0), x(7) - x(4)).theta();
    double& set = set_angle[visit(static_cast<int>(k))];
    set = crept_set(*plasticity_, theta, set, h);
  }
}

}  // namespace slipstitch
