// SPDX-License-Identifier: MIT
#pragma once

#include "model/rest_cell.h"
#include "model/topology.h"

namespace slipstitch {

/// The whole knit, tiled from `cell`: one continuous yarn, tail to tail. Flat: odd courses run -x, even ones +x, and
/// the yarn turns through two plain nodes at each selvedge. Round: every course runs -x and climbs to the next.
/// Cast-on: base nodes of course 1 are plain. Bind-off: knit_layout.h; the last tail ends in a plain node. Plain nodes
/// keep their arc length. Arc lengths start at 0. Without tails, their ends woven in, the yarn begins in the outer node
/// at the other side of the first loop's base, which it so closes, and ends in the last loop's last node, through which
/// it does not slide.
PlacedTopology build_knit(const Knit& knit, const RestCell& cell);

}  // namespace slipstitch
