// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/model.h"

namespace slipstitch {

/// Full coordinates from unknowns: q = offset + W y, W sparse by rows.
///
/// Ordinary scenes have at most one entry of weight 1 a row (`simple`): a coordinate is either an unknown or held at
/// its offset. The periodic repeat ties images to masters and period vectors with up to three entries a row.
struct DofMap {
  int num_dofs = 0;
  std::vector<int> first;      // entries of row c: [first[c], first[c+1]) (num_coords + 1)
  std::vector<int> dof;        // column of each entry
  std::vector<double> weight;  // value of each entry
  VecX offset;                 // (num_coords)
  bool simple = true;

  int num_coords() const { return static_cast<int>(first.size()) - 1; }
  /// Unknown of coordinate c, -1 if held. Only for simple maps.
  int dof_of(int c) const {
    const auto i = static_cast<std::size_t>(c);
    return first[i] == first[i + 1] ? -1 : dof[static_cast<std::size_t>(first[i])];
  }
};

/// Unknowns of a scene: positions of nodes that no handle holds; arc lengths of sliding visits when sliding is on.
/// Numbered node by node. Offsets are the start values.
DofMap make_dof_map(const Model& model);

/// q = offset + W y.
void expand(const DofMap& map, const VecX& y, VecX& q);
/// y of a simple map from q.
void restrict_to_dofs(const DofMap& map, const VecX& q, VecX& y);

}  // namespace slipstitch
