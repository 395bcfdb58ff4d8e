// SPDX-License-Identifier: MIT
#include "force/plasticity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "force/bend_geometry.h"

namespace slipstitch {
namespace {

constexpr double kSquaredSmoothing = kSetSmoothing * kSetSmoothing;

/// m and its derivatives by theta^2; theta - m without cancellation.
struct SmoothAngle {
  double f, d, dd, rounding;
  explicit SmoothAngle(double theta) {
    const double r = theta * theta + kSquaredSmoothing, root = std::sqrt(r);
    f = theta * theta / root;
    rounding = theta * kSquaredSmoothing / (root * (root + theta));
    d = 0.5 * (1.0 + kSquaredSmoothing / r) / root;
    dd = -(0.25 + 0.75 * kSquaredSmoothing / r) / (r * root);
  }
};

}  // namespace

double set_bending_energy(double k_b, double p, const Vec<11>& q, Vec<11>* g, Mat<11>* hess) {
  const double W = bend_arc(q);
  if (!(W > 0.0)) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return std::numeric_limits<double>::infinity();
  }
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta(), k = k_b / W;
  const SmoothAngle m(theta);
  BendFunction f;
  f.value = k * ((theta - p) * (theta - p) + 2.0 * p * m.rounding);
  if (g || hess) {
    const SquaredAngle phi = squared_angle(cosine, theta);
    const double slope = 1.0 - 2.0 * p * m.d;  // of V/k by theta^2
    f.c = k * slope * phi.c;
    f.cc = k * (slope * phi.cc - 2.0 * p * m.dd * phi.c * phi.c);
    f.W = -f.value / W;
    f.cW = -f.c / W;
    f.WW = 2.0 * f.value / (W * W);
    bend_derivatives(f, cosine, g, hess);
  }
  return f.value;
}

void convex_set_bending(double k_b, double p, const Vec<11>& q, Mat<11>& hess) {
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta(), W = bend_arc(q), k = 2.0 * k_b / W;
  const SmoothAngle m(theta);
  const double slope = theta * (1.0 - 2.0 * p * m.d);
  const double second = 1.0 - 2.0 * p * (m.d + 2.0 * theta * theta * m.dd);
  convex_bend_hessian({k * std::max(0.0, second), k * slope, slope / W}, cosine, theta, hess);
}

double crept_set(const PlasticityEffect& effect, double theta, double p, double h) {
  const double m = SmoothAngle(theta).f, elastic = m - p;
  const double beyond = std::abs(elastic) - effect.yield_angle_rad;
  if (!(beyond > 0.0)) return p;
  const double left = effect.yield_angle_rad + beyond * std::exp(-h / effect.relaxation_time_s);
  return std::max(0.0, m - std::copysign(left, elastic));
}

}  // namespace slipstitch
