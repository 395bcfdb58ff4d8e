// SPDX-License-Identifier: MIT
#include "sim/describe_place.h"

#include <algorithm>

namespace slipstitch {

std::string describe_contact(const Topology& topology, int contact) {
  const StitchContact& c = topology.contacts[static_cast<std::size_t>(contact)];
  if (c.stitch < 0) return "the bind-off";
  const Stitch& s = topology.stitches[static_cast<std::size_t>(c.stitch)];
  return "course " + std::to_string(s.course) + ", wale " + std::to_string(s.wale) +
         (c.side == ClaspSide::left ? " (left clasp)" : " (right clasp)");
}

std::string describe_visit(const Topology& topology, int yarn, int visit) {
  for (std::size_t c = 0; c < topology.contacts.size(); ++c) {
    const StitchContact& contact = topology.contacts[c];
    for (int v : {contact.u_visit[0], contact.u_visit[1], contact.v_visit[0], contact.v_visit[1]})
      if (v == visit) return describe_contact(topology, static_cast<int>(c));
  }
  const int point = visit - topology.yarn_first[static_cast<std::size_t>(yarn)];
  return "point " + std::to_string(point) + " of yarn " + std::to_string(yarn);
}

std::string describe_coordinate(const Topology& topology, int coord) {
  const bool is_arc = coord >= 3 * topology.num_nodes;
  const int node = coord / 3;
  if (!is_arc && node >= topology.num_nodes - topology.num_bodies)
    return "dynamic sphere " + std::to_string(node - topology.num_nodes + topology.num_bodies);
  const auto first = topology.visit_node.begin();
  const int visit = is_arc ? coord - topology.arc_coord(0)
                           : static_cast<int>(std::find(first, topology.visit_node.end(), node) - first);
  const auto after = std::upper_bound(topology.yarn_first.begin(), topology.yarn_first.end(), visit);
  return describe_visit(topology, static_cast<int>(after - topology.yarn_first.begin()) - 1, visit);
}

}  // namespace slipstitch
