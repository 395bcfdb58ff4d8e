// SPDX-License-Identifier: MIT
#include "force/wrapping.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slipstitch {
namespace {

Vec3 node(const Vec<12>& q, int slot) { return q.segment<3>(3 * slot); }

std::array<int, 12> node_coords(const Topology& topology, std::array<int, 4> nodes) {
  std::array<int, 12> coords{};
  for (std::size_t i = 0; i < 12; ++i) coords[i] = topology.x_coord(nodes[i / 3]) + static_cast<int>(i % 3);
  return coords;
}

}  // namespace

double bare_wrapping_energy(double k, double rest, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) {
  Vec<12> dpsi;
  const double t = wrap_angle_derivatives(q, g || hess ? &dpsi : nullptr, hess) - rest;
  if (g) *g = (k * t) * dpsi;
  if (hess) *hess = (k * t) * *hess + k * dpsi * dpsi.transpose();
  return 0.5 * k * t * t;
}

double wrap_excess(double psi, double rest) {
  const double t = psi - rest;
  if (t > kPi) return t - 2.0 * kPi;
  return t > -kPi ? t : t + 2.0 * kPi;
}

Jet2 wrap_well(double t) {
  constexpr double w = kWrapCapWidth, a = kPi - w;
  const double r = std::abs(t);
  if (r <= a) return {0.5 * t * t, t, 1.0};
  const double x = std::min((r - a) / w, 1.0), x2 = x * x, x4 = x2 * x2;
  const Jet2 S = smoothstep(x);
  const double area = x - x2 * x2 * (2.5 - 3.0 * x + x2);                      // int_0^x (1 - S)
  const double moment = 0.5 * x2 - x4 * x * (2.0 - 2.5 * x + 6.0 / 7.0 * x2);  // int_0^x y (1 - S)
  return {0.5 * a * a + w * (a * area + w * moment), t * (1.0 - S.f), 1.0 - S.f - r * S.d / w};
}

double wrapping_energy(const Wrap& wrap, double offset, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) {
  const bool derivatives = g || hess;
  const double k = wrap.k, fade = wrap_fade(q, wrap.L);
  if (!(fade > 0.0)) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return 0.0;
  }
  Vec<12> dpsi;
  const double psi = wrap_angle_derivatives(q, derivatives ? &dpsi : nullptr, hess);
  Jet2 E = wrap_well(wrap_excess(psi, wrap.rest));
  E.f += offset;
  if (hess) *hess = (k * fade * E.d) * *hess + (k * fade * E.dd) * dpsi * dpsi.transpose();
  if (g) *g = (k * fade * E.d) * dpsi;
  if (derivatives && fade < 1.0) {
    Vec<12> dS;
    Mat<12> ddS;
    wrap_fade_derivatives(q, wrap.L, &dS, hess ? &ddS : nullptr);
    if (g) *g += (k * E.f) * dS;
    if (hess) {
      const Vec<12> turn = (k * E.d) * dpsi;
      *hess += turn * dS.transpose() + dS * turn.transpose() + (k * E.f) * ddS;
    }
  }
  return k * fade * E.f;
}

void convex_wrapping_hessian(const Wrap& wrap, const Vec<12>& q, Mat<12>& hess) {
  const double fade = wrap_fade(q, wrap.L);
  hess.setZero();
  if (!(fade > 0.0)) return;
  Vec<12> dpsi;
  const double psi = wrap_angle_derivatives(q, &dpsi, nullptr);
  hess = (wrap.k * fade * std::max(0.0, wrap_well(wrap_excess(psi, wrap.rest)).dd)) * dpsi * dpsi.transpose();
}

Wrapping::Wrapping(const Model& model, WrapFadeForm form)
    : naive_(model.naive), offset_(form == WrapFadeForm::no_net_attraction ? -kPi * kPi / 6.0 : 0.0) {
  const auto& effect = model.effects.wrapping;
  if (!effect) return;
  const Topology& topology = model.topology;
  for (std::size_t i = 0; i < topology.contacts.size(); ++i) {
    const StitchContact& c = topology.contacts[i];
    if (!c.owned) continue;
    const double L = rest_length(topology, std::min(c.u_visit[0], c.u_visit[1]));
    const double k_w = effect->stiffness_n.value_or(effect->alpha * model.yarn.bending_nm2 / (L * L));
    for (const auto& nodes : {std::array{c.q0, c.q1, c.q3, c.q4}, std::array{c.q1, c.q0, c.q2, c.q5}}) {
      if (nodes[2] < 0 || nodes[3] < 0) continue;
      coords_.push_back(node_coords(topology, nodes));
      wraps_.push_back({k_w * L, c.sign * effect->rest_angle_rad, L});
      contact_.push_back(static_cast<int>(i));
    }
  }
}

double Wrapping::naive_energy(std::size_t k, const Vec<12>& q, Vec<12>* g, Mat<12>* hess) const {
  const bool flips = naive_.unsigned_angle && wrap_angle(node(q, 0), node(q, 1), node(q, 2), node(q, 3)) < 0.0;
  Wrap wrap = wraps_[k];
  if (naive_.unsigned_angle) wrap.rest = std::abs(wrap.rest);
  if (!flips) {
    return naive_.unfaded_wraps ? bare_wrapping_energy(wrap.k, wrap.rest, q, g, hess)
                                : wrapping_energy(wrap, offset_, q, g, hess);
  }
  // What the printed formulas give: |psi| in the energy and in the factor of derivatives that are those of psi.
  Vec<12> dpsi;
  Mat<12> ddpsi;
  const double t = -wrap_angle_derivatives(q, &dpsi, &ddpsi) - wrap.rest;
  if (g) *g = wrap.k * t * dpsi;
  if (hess) *hess = wrap.k * (dpsi * dpsi.transpose() + t * ddpsi);
  return 0.5 * wrap.k * t * t;
}

double Wrapping::least_energy() const {
  const auto add = [](double sum, const Wrap& wrap) { return sum + wrap.k; };
  return std::min(0.0, offset_) * std::accumulate(wraps_.begin(), wraps_.end(), 0.0, add);
}

}  // namespace slipstitch
