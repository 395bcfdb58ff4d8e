// SPDX-License-Identifier: MIT
#include "sim/loose_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "force/body_contact.h"
#include "sim/moves.h"
#include "solve/newton.h"

namespace slipstitch {
namespace {

constexpr double kLongestMove = 5e-3;  // of an end in one Newton step [m]

/// The energy over the ends, in place in the full coordinates.
class EndsObjective final : public Objective {
 public:
  EndsObjective(YarnForces& forces, Assembly& assembly, const std::vector<int>& coords, VecX& q)
      : forces_(forces), assembly_(assembly), coords_(coords), q_(q) {}

  double value(const VecX& z) override {
    put(z);
    return assembly_.value(forces_, q_);
  }
  double derivatives(const VecX& z, HessianMode mode, VecX& g, SparseMatrix& h) override {
    put(z);
    return assembly_.derivatives(forces_, q_, mode, g, h);
  }
  double max_step(const VecX& z, const VecX& dz) override {
    const double a = std::min(1.0, kLongestMove / std::max(dz.cwiseAbs().maxCoeff(), 1e-300));
    put(z);
    return allowed_move(forces_, q_, in_place(dz), a);
  }
  /// Whether the straight way from one place to another leads through nothing.
  bool allows(const VecX& z, const VecX& to) {
    put(z);
    return allowed_move(forces_, q_, in_place(to - z), 1.0) == 1.0;
  }
  double value_scale() const override { return assembly_.scale(); }
  void predict(const VecX& z, const VecX& dz) override {
    put(z);
    assembly_.predict(forces_, q_, in_place(dz));
  }

 private:
  void put(const VecX& z) {
    for (std::size_t i = 0; i < coords_.size(); ++i) q_[coords_[i]] = z[static_cast<Eigen::Index>(i)];
  }

  VecX in_place(const VecX& dz) const {
    VecX dq = VecX::Zero(q_.size());
    for (std::size_t i = 0; i < coords_.size(); ++i) dq[coords_[i]] = dz[static_cast<Eigen::Index>(i)];
    return dq;
  }

  YarnForces& forces_;
  Assembly& assembly_;
  const std::vector<int>& coords_;
  VecX& q_;
};

VecX pick(const std::vector<int>& coords, const VecX& q) {
  VecX z(static_cast<Eigen::Index>(coords.size()));
  for (std::size_t i = 0; i < coords.size(); ++i) z[static_cast<Eigen::Index>(i)] = q[coords[i]];
  return z;
}

DofMap map_of(const std::vector<int>& coords, int num_coords) {
  DofMap map;
  map.num_dofs = static_cast<int>(coords.size());
  map.offset = VecX::Zero(num_coords);
  map.first.assign(static_cast<std::size_t>(num_coords) + 1, 0);
  for (int c : coords) {
    map.dof.push_back(static_cast<int>(map.dof.size()));
    map.weight.push_back(1.0);
    map.first[static_cast<std::size_t>(c) + 1] = 1;
  }
  for (std::size_t c = 1; c < map.first.size(); ++c) map.first[c] += map.first[c - 1];
  return map;
}

}  // namespace

LooseEnds::LooseEnds(const Topology& topology, const YarnForces& forces, const DofMap& map)
    : is_end_(static_cast<std::size_t>(topology.num_nodes), 0), solver_(make_cholmod_solver()) {
  for (int yarn = 0; yarn < topology.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    for (int visit : {topology.yarn_first[y], topology.yarn_first[y + 1] - 1}) {
      const int node = topology.visit_node[static_cast<std::size_t>(visit)];
      if (map.dof_of(topology.x_coord(node)) >= 0) is_end_[static_cast<std::size_t>(node)] = 1;
    }
  }
  for (int node = 0; node < topology.num_nodes; ++node)
    if (contains_node(node))
      for (int c = 0; c < 3; ++c) coords_.push_back(topology.x_coord(node) + c);
  map_ = map_of(coords_, map.num_coords());
  assembly_ = std::make_unique<Assembly>(forces, map_, Stencils::touching);
}

double LooseEnds::settle(YarnForces& forces, VecX& q, const VecX& before, double step_tolerance) {
  if (coords_.empty()) return 0.0;
  EndsObjective objective(forces, *assembly_, coords_, q);
  VecX z = pick(coords_, q);
  const VecX alternative = pick(coords_, before);
  double lowest = objective.value(z);
  // Where the value here is infinite there is nothing to lose.
  if (!std::isfinite(lowest) || objective.allows(z, alternative)) {
    if (const double value = objective.value(alternative); !(lowest <= value)) {
      z = alternative;
      lowest = value;
    }
  }
  const VecX start = z;
  objective.predict(z, VecX::Zero(z.size()));
  NewtonOptions options;
  options.step_tolerance = step_tolerance;
  const NewtonReport report = newton(objective, *solver_, options, z);
  const double round_off = 1e-14 * objective.value_scale();
  if (!(objective.value(z) <= lowest + round_off)) objective.value(start);  // leaves q at the start
  const bool solved = report.status == NewtonStatus::converged || report.max_step > 0.0;
  return solved ? report.max_step : std::numeric_limits<double>::infinity();
}

}  // namespace slipstitch
