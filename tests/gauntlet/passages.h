// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "collide/near_segments.h"
#include "model/model.h"

namespace slipstitch::gauntlet {

/// Counts where yarn passes through yarn that is no neighbour: two segments whose straight ways from one accepted step
/// to the next cross. Neighbours share a node, or a segment joins theirs; their contacts hold them by construction.
class Passages {
 public:
  explicit Passages(const Model& model);

  /// Crossings from q0 to q1, added to count().
  void after_step(const VecX& q0, const VecX& q1);
  long count() const { return count_; }

 private:
  bool neighbours(int a, int b) const;

  std::vector<std::array<int, 6>> segments_;
  std::vector<std::vector<int>> joined_;  // per node: nodes that a segment joins to it, and itself
  NearSegments near_;
  long count_ = 0;
};

}  // namespace slipstitch::gauntlet
