// SPDX-License-Identifier: MIT
#include "sim/handle_forces.h"

#include <cmath>

#include "sim/simulation.h"

namespace slipstitch {

HandleForces::HandleForces(const Simulation& sim, std::size_t num_handles) : total_(num_handles), report_(num_handles) {
  if (num_handles == 0) return;
  const Topology& topo = sim.model().topology;
  held_.assign(static_cast<std::size_t>(topo.num_coords()), 0);
  handle_.assign(static_cast<std::size_t>(topo.num_nodes), -1);
  for (const ScriptedNodes& script : sim.model().handles) {
    if (script.handle < 0) continue;
    for (const int node : script.nodes) {
      handle_[static_cast<std::size_t>(node)] = script.handle;
      for (int c = 0; c < 3; ++c) held_[static_cast<std::size_t>(topo.x_coord(node) + c)] = 1;
    }
  }
}

const std::vector<Vec3>& HandleForces::observe(const Simulation& sim) {
  if (empty()) return total_;
  gradient_.setZero(sim.model().topology.num_coords());
  std::apply([&](const auto&... term) { (add_full_gradient(term, sim.state().q, held_, gradient_), ...); },
             sim.forces());
  std::fill(total_.begin(), total_.end(), Vec3::Zero());
  for (std::size_t node = 0; node < handle_.size(); ++node)
    if (handle_[node] >= 0)
      total_[static_cast<std::size_t>(handle_[node])] += gradient_.segment<3>(3 * static_cast<Eigen::Index>(node));
  for (std::size_t i = 0; i < total_.size(); ++i) {
    HandleForce& force = report_[i];
    force.reaction_n = total_[i];
    const double size = total_[i].norm();
    if (std::islessequal(size, force.max_reaction_n)) continue;  // NaN before the first step
    force.max_reaction_n = size;
    force.max_reaction_t_s = sim.state().t;
  }
  return total_;
}

}  // namespace slipstitch
