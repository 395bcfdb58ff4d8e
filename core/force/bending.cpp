// SPDX-License-Identifier: MIT
#include "force/bending.h"

#include <limits>

#include "force/bend_geometry.h"
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

void Bending::convex_hessian(int, const Vec<11>& q, Mat<11>& hess) const {
  const double W = bend_arc(q), k = 2.0 * k_b_ / W;
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta();
  convex_bend_hessian({k, k * theta, theta / W}, cosine, theta, hess);
}

Bending::Bending(const Model& model) : k_b_(model.yarn.bending_nm2) {
  if (!model.effects.bending) return;
  for_each_owned_bend(model.topology, [&](int, int i) { coords_.push_back(bend_coords(model.topology, i)); });
}

}  // namespace slipstitch
