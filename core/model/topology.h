// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "math/types.h"

namespace slipstitch {

/// Yarns as sequences of visits to shared nodes.
///
/// A visit is one passage of one yarn through one node and carries that yarn's arc length there; a node has one
/// position, shared by all its visits. Visits are numbered consecutively along each yarn, yarn after yarn, with arc
/// length increasing. Segment i joins visits i and i+1; it exists unless i is the last visit of its yarn.
///
/// Nodes that no visit names are the last ones: the centres of the dynamic colliders, in their order.
///
/// Full coordinates q: the positions of all nodes, then the arc lengths of all visits:
///   q[3 n + c] = component c of node n [m],   q[3 num_nodes + i] = arc length of visit i [m].

enum class StitchKind : std::uint8_t { knit, purl };
enum class ClaspSide : std::uint8_t { left, right };

/// The persistent contact of a new loop N (yarn u) with an old loop O (yarn v): a segment of two nodes.
/// Geometry labels as in Cirio et al. 2017, stitch contact figure: u: q4 -> q0 -> q1 -> q5, v: q2 -> q0 -> q1 -> q3.
/// For both clasps q0 = P1 = (O leg) x (N sinker), q1 = P2 = (N leg) x (O head). Arc length of a yarn may run against
/// this order; labels follow geometry.
struct StitchContact {
  int q0 = -1, q1 = -1;                  // nodes
  int q4 = -1, q5 = -1, q2 = -1, q3 = -1;  // next contact (or plain edge) node of each yarn; -1: none, no wrap there
  std::array<int, 2> u_visit{-1, -1};    // visits of yarn u at q0 and q1
  std::array<int, 2> v_visit{-1, -1};    // visits of yarn v at q0 and q1
  int sign = 1;                          // s = (+1 knit, -1 purl) * (+1 left clasp, -1 right clasp)
  StitchKind kind = StitchKind::knit;
  ClaspSide side = ClaspSide::left;
  int stitch = -1;    // stitch whose base this clasp is; -1: bind-off
  bool owned = true;  // false: image of a contact of the periodic repeat, carries no energy
};

/// One loop. Contacts are -1 where the loop has none (cast-on base, open head).
struct Stitch {
  int course = 0, wale = 0;  // 1-based; course 1 at the bottom, wale 1 at the left edge seen from the right side
  StitchKind kind = StitchKind::knit;
  int base_left = -1, base_right = -1, head_left = -1, head_right = -1;  // contact indices
  std::array<int, 8> node{};  // in the yarn's geometric order BL1 BL2 HL1 HL2 HR2 HR1 BR2 BR1
};

enum class SegmentKind : std::uint8_t { none, free, contact };  // none: behind the last visit of a yarn

struct Topology {
  int num_nodes = 0, num_bodies = 0;           // nodes, the last num_bodies of them without yarn
  std::vector<int> yarn_first;                 // first visit of yarn y, closed by the visit count (num_yarns + 1)
  std::vector<int> visit_node;                 // (num_visits)
  std::vector<std::uint8_t> visit_slides;      // 1: arc length is an unknown when sliding is on (num_visits)
  std::vector<std::uint8_t> visit_owned;       // 0: image in a periodic repeat; empty: all owned (num_visits)
  std::vector<std::uint8_t> visit_extra;       // 1: its node only bends free yarn, refine.h; empty: none (num_visits)
  std::vector<SegmentKind> segment_kind;       // of segment i (num_visits)
  std::vector<double> rest_arc;                // arc length of visit i at rest [m] (num_visits)
  std::vector<int> yarn_material;              // (num_yarns)
  std::vector<double> density_scale;           // rho in the simulation / rho of the yarn, 1/c_L (num_yarns)
  std::vector<StitchContact> contacts;
  std::vector<Stitch> stitches;
  int num_courses = 0, num_wales = 0;          // 0: no knit

  int num_yarn_nodes() const { return num_nodes - num_bodies; }
  int num_yarns() const { return static_cast<int>(yarn_material.size()); }
  int num_visits() const { return static_cast<int>(visit_node.size()); }
  int num_coords() const { return 3 * num_nodes + num_visits(); }
  int x_coord(int node) const { return 3 * node; }
  int arc_coord(int visit) const { return 3 * num_nodes + visit; }
  bool extra(int visit) const { return !visit_extra.empty() && visit_extra[static_cast<std::size_t>(visit)] != 0; }
  bool owned(int visit) const { return visit_owned.empty() || visit_owned[static_cast<std::size_t>(visit)] != 0; }
};

/// A topology with a place in space: full coordinates q (num_coords).
struct PlacedTopology {
  Topology topology;
  VecX q;
};

}  // namespace slipstitch
