// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scene.h"
#include "model/topology.h"

namespace slipstitch {

/// The scene's bare yarns: yarn y of the topology is scene.yarns[y], visit yarn_first[y] + i its point i. The two
/// points of a crossing share a node; there and at guides the yarn slides.
PlacedTopology build_bare_yarns(const Scene& scene);

/// Node of a point.
int node_of_point(const Topology& topology, int yarn, int point);

/// Appends all of `other` behind `placed`: nodes, yarns, contacts and stitches renumbered, coordinates joined.
void append(const PlacedTopology& other, PlacedTopology& placed);

}  // namespace slipstitch
