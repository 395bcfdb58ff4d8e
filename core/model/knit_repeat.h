// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "model/rest_cell.h"
#include "model/topology.h"

namespace slipstitch {

/// One repeat of an endless knit, with the images that the stencils of its own (owned) elements reach. Every course is
/// a yarn of its own, running +x. Nodes 0 .. num_masters - 1 are the repeat's own: 4 a stitch in RestCell's order, then
/// the extra nodes of its free segments in theirs.
///   x(node) = x(node_master) + shift[0] * period_course + shift[1] * period_wale
///   arc(visit) = arc(visit_master) + visit_arc_offset
/// Segments belong to their first visit, bending triples to their middle one. Yarn 0 is the image of the last course
/// below the first; contacts are the bases of the repeat's stitches, all owned.
struct PeriodicPatch {
  PlacedTopology placed;
  int num_masters = 0;
  std::vector<int> node_master;                // (num_nodes)
  std::vector<std::array<int, 2>> node_shift;  // (wale periods, course periods) along period_course, period_wale
  std::vector<int> visit_master;               // (num_visits)
  std::vector<double> visit_arc_offset;        // [m] (num_visits)
  Vec3 period_course = Vec3::Zero(), period_wale = Vec3::Zero();  // as drawn
  int courses = 0, wales = 0, extra_nodes = 0;
};

/// The patch of `cell`; the kinds are the lower left corner of `pattern`.
PeriodicPatch build_repeat(const Pattern& pattern, const RestCell& cell);

/// Reads a relaxed patch back: master coordinates of `q` and the period vectors. The result lies flat with
/// period_course along +x, mean z 0, the lowest node at y = 0 and the first stitch centred in its cell.
RestCell cell_from_patch(const PeriodicPatch& patch, const VecX& q, const Vec3& period_course, const Vec3& period_wale);

}  // namespace slipstitch
