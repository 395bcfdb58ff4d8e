// SPDX-License-Identifier: MIT
#include "force/bending.h"

#include <algorithm>
#include <limits>

#include "force/bend_geometry.h"
#include "force/segments.h"

namespace slipstitch {
namespace {

constexpr double kSmallestSine = 1e-12;  // keeps the cone at theta = pi finite

// theta^2 as a function of cos theta: first and second derivative.
struct SquaredAngle {
  double c, cc;
};

SquaredAngle squared_angle_derivatives(const Cosine& cosine, double theta) {
  if (theta < 0.05) {  // Taylor in theta^2; the closed forms cancel
    const double x = theta * theta;
    return {-2.0 * (1.0 + x * (1.0 / 6 + x * (7.0 / 360 + x * (31.0 / 15120 + x * 127.0 / 604800)))),
            2.0 / 3 + x * (4.0 / 15 + x * (4.0 / 63 + x * (8.0 / 675 + x * 4.0 / 2079)))};
  }
  const double s = std::max(cosine.s, kSmallestSine);
  return {-2.0 * theta / s, 2.0 * (s - theta * cosine.c) / (s * s * s)};
}

}  // namespace

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
    const SquaredAngle phi = squared_angle_derivatives(cosine, theta);
    f.c = k * phi.c;
    f.cc = k * phi.cc;
    f.W = -f.value / W;
    f.cW = -f.c / W;
    f.WW = 2.0 * f.value / (W * W);
    bend_derivatives(f, cosine, g, hess);
  }
  return f.value;
}

Bending::Bending(const Model& model) : k_b_(model.yarn.bending_nm2) {
  if (!model.effects.bending) return;
  for_each_owned_bend(model.topology, [&](int, int i) { coords_.push_back(bend_coords(model.topology, i)); });
}

}  // namespace slipstitch
