// SPDX-License-Identifier: MIT
#include "force/parallel_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "force/segments.h"

namespace slipstitch {
namespace {

constexpr double kBarrierFrom = 0.5;  // of d

// A node that two visits share is a contact; one that slides without being shared is a guide.
std::vector<bool> contact_visits(const Topology& topology) {
  std::vector<int> visits_of_node(static_cast<std::size_t>(topology.num_nodes), 0);
  for (int node : topology.visit_node) ++visits_of_node[static_cast<std::size_t>(node)];
  std::vector<bool> contact(topology.visit_node.size());
  for (std::size_t i = 0; i < contact.size(); ++i) {
    contact[i] = topology.visit_slides[i] != 0 || visits_of_node[static_cast<std::size_t>(topology.visit_node[i])] > 1;
  }
  return contact;
}

}  // namespace

double parallel_contact_energy(double k_c, double L, double d, const Vec<2>& q, Vec<2>* g, Mat<2>* hess) {
  const double gap = std::min(q[1] - q[0] - d, 0.0);
  const double k = gap < 0.0 ? k_c * L : 0.0;
  if (g) *g << -k * gap, k * gap;
  if (hess) *hess << k, -k, -k, k;
  return 0.5 * k * gap * gap;
}

double parallel_contact_barrier(double k_c, double L, double d, const Vec<2>& q, Vec<2>* g, Mat<2>* hess) {
  const double b = kBarrierFrom * d, r = (q[1] - q[0]) / b;
  if (r >= 1.0) {
    if (g) g->setZero();
    if (hess) hess->setZero();
    return 0.0;
  }
  if (!(r > 0.0)) return std::numeric_limits<double>::infinity();
  const double scale = k_c * L * d * d, ln = std::log(r), m = r - 1.0;
  const double force = -scale * (2.0 * m * ln + m * m / r) / b;
  const double stiffness = -scale * (2.0 * ln + 4.0 * m / r - m * m / (r * r)) / (b * b);
  if (g) *g << -force, force;
  if (hess) *hess << stiffness, -stiffness, -stiffness, stiffness;
  return -scale * m * m * ln;
}

double ParallelContact::add_barrier(std::size_t i, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
  Vec<kSize> force;
  Mat<kSize> stiffness;
  const double v =
      parallel_contact_barrier(k_c_, rest_[i], distance_[i], q, g ? &force : nullptr, hess ? &stiffness : nullptr);
  if (g) *g += force;
  if (hess) *hess += stiffness;
  return v;
}

ParallelContact::ParallelContact(const Model& model) {
  const auto& effect = model.effects.parallel_contact;
  if (!effect) return;
  const double diameter = 2.0 * model.yarn.radius_m;
  k_c_ = effect->stiffness_n_per_m2.value_or(model.yarn.stretch_n / (diameter * diameter));
  const Topology& topology = model.topology;
  const std::vector<bool> contact = contact_visits(topology);
  for_each_owned_segment(topology, [&](int yarn, int i) {
    const auto s = static_cast<std::size_t>(i), y = static_cast<std::size_t>(yarn);
    if (i == topology.yarn_first[y] || i + 2 == topology.yarn_first[y + 1]) return;  // an end is no knot
    if (topology.segment_kind[s] != SegmentKind::free || (!contact[s] && !contact[s + 1])) return;
    const double rest = rest_length(topology, i);
    coords_.push_back({topology.arc_coord(i), topology.arc_coord(i + 1)});
    rest_.push_back(rest);
    distance_.push_back(std::min(diameter, effect->rest_ratio * rest));
  });
}

}  // namespace slipstitch
