// SPDX-License-Identifier: MIT
#pragma once

#include "model/topology.h"

namespace slipstitch {

/// Where one loop lies on its yarn: eight consecutive visits, along or against the geometric order.
struct LoopRun {
  int first = -1;
  int direction = 1;  // +1: the yarn runs +x, arc length along BL1 .. BR1
  int visit(int k) const { return direction > 0 ? first + k : first + 7 - k; }
};

/// The contact of yarn u and yarn v whose visits at (q0, q1) are given. Outer nodes are the neighbours on each yarn.
StitchContact make_contact(const Topology& topology, std::array<int, 2> u_visit, std::array<int, 2> v_visit,
                           StitchKind kind, ClaspSide side, int stitch);

/// The clasps at the base of stitch `stitch`, whose loop `above` is drawn through the loop `below`: first left, then
/// right. Returns the index of the left one.
int add_base_clasps(Topology& topology, const LoopRun& above, const LoopRun& below, int stitch, bool owned);

/// Appends a visit and fills the per-visit arrays.
int add_visit(Topology& topology, int node, bool slides, double rest_arc);

/// Segment kinds from contacts: between the two visits of a contact `contact`, behind a yarn's end `none`, else `free`.
void mark_segments(Topology& topology);

}  // namespace slipstitch
