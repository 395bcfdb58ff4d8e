// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/model.h"

namespace slipstitch {

/// 1 for every node whose position a handle prescribes (num_nodes).
inline std::vector<char> scripted_nodes(const Model& model) {
  std::vector<char> scripted(static_cast<std::size_t>(model.topology.num_nodes), 0);
  for (const ScriptedNodes& handle : model.handles)
    for (int node : handle.nodes) scripted[static_cast<std::size_t>(node)] = 1;
  return scripted;
}

}  // namespace slipstitch
