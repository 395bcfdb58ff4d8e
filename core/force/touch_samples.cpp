// SPDX-License-Identifier: MIT
#include "force/touch_samples.h"

#include <cmath>

#include "force/scripted_nodes.h"
#include "force/segments.h"

namespace slipstitch {

std::vector<TouchSample> touch_samples(const Model& model, double spacing, TouchPoints points) {
  const Topology& topology = model.topology;
  std::vector<char> scripted = scripted_nodes(model);
  if (points == TouchPoints::all) scripted.assign(scripted.size(), 0);
  std::vector<char> taken(scripted.size(), 0);
  std::vector<TouchSample> samples;
  for_each_owned_segment(topology, [&](int, int i) {
    const auto v = static_cast<std::size_t>(i);
    const int n0 = topology.visit_node[v], n1 = topology.visit_node[v + 1];
    const int x0 = topology.x_coord(n0), x1 = topology.x_coord(n1);
    const auto add = [&](double share) { samples.push_back({i, share, {x0, x0 + 1, x0 + 2, x1, x1 + 1, x1 + 2}}); };
    const auto add_node = [&](int node, double share) {
      const auto n = static_cast<std::size_t>(node);
      if (!taken[n] && !scripted[n]) add(share);
      taken[n] = 1;
    };
    add_node(n0, 0.0);
    add_node(n1, 1.0);
    if (scripted[static_cast<std::size_t>(n0)] && scripted[static_cast<std::size_t>(n1)]) return;
    const int pieces = static_cast<int>(std::ceil(rest_length(topology, i) / spacing - 1e-9));
    for (int k = 1; k < pieces; ++k) add(static_cast<double>(k) / pieces);
  });
  return samples;
}

}  // namespace slipstitch
