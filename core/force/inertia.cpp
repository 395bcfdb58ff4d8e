// SPDX-License-Identifier: MIT
#include "force/inertia.h"

#include "force/kinetic.h"
#include "force/segments.h"

namespace slipstitch {

Inertia::Inertia(const Model& model) {
  if (!model.effects.inertia) return;
  velocity_terms_ = !model.naive.no_velocity_terms;
  const Topology& topo = model.topology;
  std::vector<char> node_taken(static_cast<std::size_t>(topo.num_nodes), 0);
  std::vector<char> visit_taken(static_cast<std::size_t>(topo.num_visits()), 0);
  const double fraction = model.effects.sliding ? model.effects.inertia->sliding_mass_fraction : 0.0;
  for_each_owned_segment(topo, [&](int yarn, int i) {
    const double rho = linear_density(model, yarn);
    const double half_mass = 0.5 * fraction * rho * rest_length(topo, i);
    coords_.push_back(segment_coords(topo, i));
    density_.push_back(rho);
    std::array<double, 2> arc_mass{};
    std::array<bool, 2> owner{}, node_owner{};
    for (std::size_t end = 0; end < 2; ++end) {
      const auto visit = static_cast<std::size_t>(i) + end;
      const auto node = static_cast<std::size_t>(topo.visit_node[visit]);
      arc_mass[end] = topo.visit_slides[visit] ? half_mass : 0.0;
      owner[end] = !visit_taken[visit];
      node_owner[end] = !node_taken[node];
      visit_taken[visit] = node_taken[node] = 1;
    }
    arc_mass_.push_back(arc_mass);
    owner_.push_back(owner);
    node_owner_.push_back(node_owner);
  });
  mass_.resize(coords_.size(), Mat<8>::Zero());
  linear_.resize(coords_.size(), Vec<8>::Zero());
  start_.resize(coords_.size(), Vec<8>::Zero());
}

Mat<8> Inertia::mass(int k, const Vec<8>& q) const {
  const auto i = static_cast<std::size_t>(k);
  Mat<8> m = kinetic_mass(density_[i], q);
  m(3, 3) += arc_mass_[i][0];
  m(7, 7) += arc_mass_[i][1];
  return m;
}

void Inertia::begin_step(const StepContext& step) {
  h_ = step.h;
  for (int k = 0; k < size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    Vec<8> q, v, p;
    for (int j = 0; j < 8; ++j) {
      const int c = coords_[i][static_cast<std::size_t>(j)];
      const std::size_t end = j < 4 ? 0 : 1;
      const bool mine = j % 4 == 3 ? owner_[i][end] : node_owner_[i][end];
      start_[i][j] = step.sum(0.0, [&](const Past& known) { return (*known.q)[c]; });
      q[j] = (*step.near_q)[c];
      v[j] = (*step.near_v)[c];
      p[j] = mine ? step.sum(0.0, [&](const Past& known) { return (*known.p)[c]; }) : 0.0;
    }
    mass_[i] = mass(k, q);
    linear_[i] = velocity_terms_ ? Vec<8>(p + h_ * kinetic_gradient(density_[i], q, v)) : mass_[i] * v;
  }
}

double Inertia::eval(int k, const Vec<8>& q, Vec<8>* g, Mat<8>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  const Vec<8> d = q - start_[i];
  const Vec<8> md = mass_[i] * d / (h_ * h_);
  if (g) *g = md - linear_[i] / h_;
  if (hess) *hess = mass_[i] / (h_ * h_);
  return 0.5 * d.dot(md) - d.dot(linear_[i]) / h_;
}

namespace {

Vec<8> gather(const std::array<int, 8>& coords, const VecX& full) {
  Vec<8> local;
  for (int j = 0; j < 8; ++j) local[j] = full[coords[static_cast<std::size_t>(j)]];
  return local;
}

}  // namespace

VecX Inertia::momentum(const VecX& q, const VecX& v) const {
  VecX p = VecX::Zero(q.size());
  for (int k = 0; k < size(); ++k) {
    const auto coords = this->coords(k);
    const Vec<8> local = mass(k, gather(coords, q)) * gather(coords, v);
    for (int j = 0; j < 8; ++j) p[coords[static_cast<std::size_t>(j)]] += local[j];
  }
  return p;
}

double Inertia::kinetic_energy(const VecX& q, const VecX& v) const {
  double energy = 0.0;
  for (int k = 0; k < size(); ++k) {
    const Vec<8> local = gather(coords(k), v);
    energy += 0.5 * local.dot(mass(k, gather(coords(k), q)) * local);
  }
  return energy;
}

}  // namespace slipstitch
