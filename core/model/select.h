// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/scene.h"
#include "model/topology.h"

namespace slipstitch {

/// The nodes a checked selector means, ascending, each once. Yarns count as in the topology: the scene's bare yarns,
/// then the knit's yarn.
std::vector<int> select_nodes(const Selector& selector, const Topology& topology);

}  // namespace slipstitch
