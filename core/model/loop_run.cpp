// SPDX-License-Identifier: MIT
#include "model/loop_run.h"

#include <algorithm>

namespace slipstitch {
namespace {

// The node next to `inner` on the side away from `other`, -1 at the yarn's end.
int node_beyond(const Topology& topology, int inner, int other) {
  const int next = inner + (inner - other);
  if (next < 0 || next >= topology.num_visits()) return -1;
  const auto yarn_of = [&](int visit) {
    return std::upper_bound(topology.yarn_first.begin(), topology.yarn_first.end(), visit);
  };
  return yarn_of(next) == yarn_of(inner) ? topology.visit_node[static_cast<std::size_t>(next)] : -1;
}

}  // namespace

StitchContact make_contact(const Topology& topology, std::array<int, 2> u_visit, std::array<int, 2> v_visit,
                           StitchKind kind, ClaspSide side, int stitch) {
  StitchContact contact;
  contact.q0 = topology.visit_node[static_cast<std::size_t>(u_visit[0])];
  contact.q1 = topology.visit_node[static_cast<std::size_t>(u_visit[1])];
  contact.q4 = node_beyond(topology, u_visit[0], u_visit[1]);
  contact.q5 = node_beyond(topology, u_visit[1], u_visit[0]);
  contact.q2 = node_beyond(topology, v_visit[0], v_visit[1]);
  contact.q3 = node_beyond(topology, v_visit[1], v_visit[0]);
  contact.u_visit = u_visit;
  contact.v_visit = v_visit;
  contact.sign = (kind == StitchKind::knit ? 1 : -1) * (side == ClaspSide::left ? 1 : -1);
  contact.kind = kind;
  contact.side = side;
  contact.stitch = stitch;
  return contact;
}

int add_base_clasps(Topology& topology, const LoopRun& above, const LoopRun& below, int stitch, bool owned) {
  const int left = static_cast<int>(topology.contacts.size());
  const StitchKind kind = topology.stitches[static_cast<std::size_t>(stitch)].kind;
  topology.contacts.push_back(make_contact(topology, {above.visit(0), above.visit(1)}, {below.visit(2), below.visit(3)},
                                           kind, ClaspSide::left, stitch));
  topology.contacts.push_back(make_contact(topology, {above.visit(7), above.visit(6)}, {below.visit(5), below.visit(4)},
                                           kind, ClaspSide::right, stitch));
  topology.contacts[static_cast<std::size_t>(left)].owned = owned;
  topology.contacts[static_cast<std::size_t>(left) + 1].owned = owned;
  return left;
}

int add_visit(Topology& topology, int node, bool slides, double rest_arc) {
  topology.visit_node.push_back(node);
  topology.visit_slides.push_back(slides ? 1 : 0);
  topology.rest_arc.push_back(rest_arc);
  return topology.num_visits() - 1;
}

void mark_segments(Topology& topology) {
  auto& kinds = topology.segment_kind;
  kinds.assign(topology.visit_node.size(), SegmentKind::free);
  for (std::size_t yarn = 1; yarn < topology.yarn_first.size(); ++yarn) {
    kinds[static_cast<std::size_t>(topology.yarn_first[yarn] - 1)] = SegmentKind::none;
  }
  for (const StitchContact& contact : topology.contacts) {
    for (const auto& pair : {contact.u_visit, contact.v_visit}) {
      kinds[static_cast<std::size_t>(std::min(pair[0], pair[1]))] = SegmentKind::contact;
    }
  }
}

}  // namespace slipstitch
