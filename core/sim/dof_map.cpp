// SPDX-License-Identifier: MIT
#include "sim/dof_map.h"

namespace slipstitch {
namespace {

struct Held {
  std::vector<char> position;  // (num_nodes)
  std::vector<char> arc;       // of all visits of the node (num_nodes)
};

Held held_nodes(const Model& model) {
  const auto n = static_cast<std::size_t>(model.topology.num_nodes);
  Held held{std::vector<char>(n, 0), std::vector<char>(n, 0)};
  for (const auto& handle : model.handles) {
    for (int node : handle.nodes) {
      held.position[static_cast<std::size_t>(node)] = 1;
      if (handle.fix_arc_length) held.arc[static_cast<std::size_t>(node)] = 1;
    }
  }
  return held;
}

}  // namespace

DofMap make_dof_map(const Model& model) {
  const Topology& topo = model.topology;
  const Held held = held_nodes(model);
  std::vector<std::vector<int>> free_visits(static_cast<std::size_t>(topo.num_nodes));
  if (model.effects.sliding) {
    for (int i = 0; i < topo.num_visits(); ++i) {
      const auto node = static_cast<std::size_t>(topo.visit_node[static_cast<std::size_t>(i)]);
      if (topo.visit_slides[static_cast<std::size_t>(i)] && !held.arc[node]) free_visits[node].push_back(i);
    }
  }
  std::vector<int> dof_of(static_cast<std::size_t>(topo.num_coords()), -1);
  int next = 0;
  for (int n = 0; n < topo.num_nodes; ++n) {
    if (!held.position[static_cast<std::size_t>(n)])
      for (int c = 0; c < 3; ++c) dof_of[static_cast<std::size_t>(topo.x_coord(n) + c)] = next++;
    for (int i : free_visits[static_cast<std::size_t>(n)]) dof_of[static_cast<std::size_t>(topo.arc_coord(i))] = next++;
  }
  DofMap map;
  map.num_dofs = next;
  map.offset = model.start_q;
  map.first.push_back(0);
  for (int c = 0; c < topo.num_coords(); ++c) {
    if (dof_of[static_cast<std::size_t>(c)] >= 0) {
      map.dof.push_back(dof_of[static_cast<std::size_t>(c)]);
      map.weight.push_back(1.0);
      map.offset[c] = 0.0;
    }
    map.first.push_back(static_cast<int>(map.dof.size()));
  }
  return map;
}

void expand(const DofMap& map, const VecX& y, VecX& q) {
  q = map.offset;
  for (int c = 0; c < map.num_coords(); ++c)
    for (int k = map.first[static_cast<std::size_t>(c)]; k < map.first[static_cast<std::size_t>(c) + 1]; ++k)
      q[c] += map.weight[static_cast<std::size_t>(k)] * y[map.dof[static_cast<std::size_t>(k)]];
}

void restrict_to_dofs(const DofMap& map, const VecX& q, VecX& y) {
  y.resize(map.num_dofs);
  for (int c = 0; c < map.num_coords(); ++c)
    if (const int d = map.dof_of(c); d >= 0) y[d] = q[c];
}

}  // namespace slipstitch
