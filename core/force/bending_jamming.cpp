// SPDX-License-Identifier: MIT
#include "force/bending_jamming.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "force/bend_geometry.h"
#include "force/segments.h"
#include "math/smoothstep.h"

namespace slipstitch {
namespace {

// f - 1 as a function of kappa.
Jet2 jamming_factor(const JammingParameters& p, double kappa_j, double kappa) {
  const double slope = 1.0 / (kappa_j * (p.full_at - 1.0));
  const Jet2 S = smoothstep((kappa - kappa_j) * slope);
  const double a = p.log_max_factor;
  const double f = std::exp(a * S.f);
  const double d = a * S.d * slope;
  return {std::expm1(a * S.f), f * d, f * (d * d + a * S.dd * slope * slope)};
}

// k_b/4 (f - 1) kappa^2 as a function of kappa = 2 theta/W; the energy is W times this.
Jet2 jamming_density(double k_b, const Jet2& f, double kappa) {
  const double k = 0.25 * k_b;
  return {k * f.f * kappa * kappa, k * (f.d * kappa * kappa + 2.0 * f.f * kappa),
          k * (f.dd * kappa * kappa + 4.0 * f.d * kappa + 2.0 * f.f)};
}

BendFunction jammed_bend(const Jet2& G, double theta, double kappa, double W, const Cosine& cosine) {
  const double d_theta = 2.0 * G.d;        // dV/dtheta
  const double dd_theta = 4.0 * G.dd / W;  // d2V/dtheta2
  const double dd_mixed = -2.0 * theta * 2.0 * G.dd / (W * W);
  const double s = std::max(cosine.s, 1e-12);  // cone at theta = pi, as in bending
  BendFunction b;
  b.value = W * G.f;
  b.c = -d_theta / s;
  b.cc = (dd_theta * s - d_theta * cosine.c) / (s * s * s);
  b.W = G.f - kappa * G.d;
  b.cW = -dd_mixed / s;
  b.WW = kappa * kappa * G.dd / W;
  return b;
}

/// Of the visits on either side of visit i that refinement did not add; 0 at a yarn's end. [m]
double arc_between_coarse(const Topology& topology, int i) {
  int before = i - 1, behind = i + 1;
  while (before >= 0 && topology.extra(before)) --before;
  while (behind < topology.num_visits() && topology.extra(behind)) ++behind;
  const auto v = static_cast<std::size_t>(i);
  if (before < 0 || behind == topology.num_visits()) return 0.0;
  if (topology.segment_kind[static_cast<std::size_t>(before)] == SegmentKind::none ||
      topology.segment_kind[v] == SegmentKind::none)
    return 0.0;
  return topology.rest_arc[static_cast<std::size_t>(behind)] - topology.rest_arc[static_cast<std::size_t>(before)];
}

/// Arc length at rest over the bend at visit i of the yarn without extra nodes, so that they switch nothing off; at one
/// of them in between its neighbours'.
double coarse_bend_arc(const Topology& topology, int i) {
  if (!topology.extra(i)) return arc_between_coarse(topology, i);
  int before = i, behind = i;
  while (topology.extra(before)) --before;
  while (topology.extra(behind)) ++behind;
  const double W0 = arc_between_coarse(topology, before), W1 = arc_between_coarse(topology, behind);
  if (W0 == 0.0 || W1 == 0.0) return std::max(W0, W1);
  return W0 + (W1 - W0) * (i - before) / (behind - before);
}

}  // namespace

double bending_jamming_energy(const JammingParameters& p, double kappa_j, const Vec<11>& q, Vec<11>* g, Mat<11>* hess) {
  const double W = bend_arc(q);
  const bool ordered = W > 0.0;
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta();
  const double kappa = ordered ? 2.0 * theta / W : 0.0;
  if (!(kappa > kappa_j)) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return ordered ? 0.0 : std::numeric_limits<double>::infinity();
  }
  const Jet2 G = jamming_density(p.k_b, jamming_factor(p, kappa_j, kappa), kappa);
  const BendFunction b = jammed_bend(G, theta, kappa, W, cosine);
  if (g || hess) bend_derivatives(b, cosine, g, hess);
  return b.value;
}

void BendingJamming::convex_hessian(int k, const Vec<11>& q, Mat<11>& hess) const {
  const double kappa_j = kappa_j_[static_cast<std::size_t>(k)], W = bend_arc(q);
  const Cosine cosine = bend_cosine(q);
  const double theta = cosine.theta(), kappa = 2.0 * theta / W;
  hess.setZero();
  if (!(kappa > kappa_j)) return;
  const Jet2 G = jamming_density(parameters_.k_b, jamming_factor(parameters_, kappa_j, kappa), kappa);
  convex_bend_hessian({std::max(0.0, 4.0 * G.dd / W), 2.0 * G.d, theta / W}, cosine, theta, hess);
}

BendingJamming::BendingJamming(const Model& model) {
  const auto& effect = model.effects.bending_jamming;
  if (!effect) return;
  parameters_ = {model.yarn.bending_nm2, std::log(effect->max_factor), effect->full_at};
  for_each_owned_bend(model.topology, [&](int, int i) {
    coords_.push_back(bend_coords(model.topology, i));
    kappa_j_.push_back(kPi / coarse_bend_arc(model.topology, i));
  });
}

}  // namespace slipstitch
