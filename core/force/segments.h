// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "model/topology.h"

namespace slipstitch {

/// Calls f(yarn, i) for every owned segment i (visits i and i+1).
template <class F>
void for_each_owned_segment(const Topology& topology, F&& f) {
  for (int yarn = 0; yarn < topology.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    for (int i = topology.yarn_first[y]; i + 1 < topology.yarn_first[y + 1]; ++i) {
      if (topology.owned(i)) f(yarn, i);
    }
  }
}

/// Calls f(yarn, i) for every owned visit i that has a visit on either side.
template <class F>
void for_each_owned_bend(const Topology& topology, F&& f) {
  for (int yarn = 0; yarn < topology.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    for (int i = topology.yarn_first[y] + 1; i + 1 < topology.yarn_first[y + 1]; ++i) {
      if (topology.owned(i)) f(yarn, i);
    }
  }
}

inline int position_coord(const Topology& topology, int visit) {
  return topology.x_coord(topology.visit_node[static_cast<std::size_t>(visit)]);
}

/// x0, u0, x1, u1 of segment i.
inline std::array<int, 8> segment_coords(const Topology& topology, int i) {
  const int x0 = position_coord(topology, i), x1 = position_coord(topology, i + 1);
  return {x0, x0 + 1, x0 + 2, topology.arc_coord(i), x1, x1 + 1, x1 + 2, topology.arc_coord(i + 1)};
}

/// x2, u2, x0, x1, u1 of the bend at visit i between visits i-1 (2) and i+1 (1).
inline std::array<int, 11> bend_coords(const Topology& topology, int i) {
  const int x2 = position_coord(topology, i - 1), x0 = position_coord(topology, i),
            x1 = position_coord(topology, i + 1);
  return {x2, x2 + 1, x2 + 2, topology.arc_coord(i - 1), x0, x0 + 1, x0 + 2,
          x1, x1 + 1, x1 + 2, topology.arc_coord(i + 1)};
}

}  // namespace slipstitch
