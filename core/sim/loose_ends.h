// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "sim/assembly.h"
#include "solve/linear_solver.h"

namespace slipstitch {

/// The free ends of the yarns. A tail of one segment weighs and resists next to nothing: it turns through large angles
/// while the rest of the fabric hardly moves, and would cost the whole system ten Newton iterations that it alone needs.
/// Here the ends are solved for on their own, all else held.
class LooseEnds {
 public:
  LooseEnds(const Topology& topology, const YarnForces& forces, const DofMap& map);

  bool contains_node(int node) const { return is_end_[static_cast<std::size_t>(node)] != 0; }
  const std::vector<int>& coords() const { return coords_; }  // full coordinates of the ends

  /// Minimises over the ends in q (full coordinates), from where they are in q or in `before`, whichever is lower, but
  /// past no dynamic sphere, until a Newton step is <= step_tolerance [m]. Never raises the energy. Returns the size of
  /// the last step, infinity if there was none.
  double settle(YarnForces& forces, VecX& q, const VecX& before, double step_tolerance);

  /// What the terms took here, beside what they took in the whole.
  EffectCosts costs(const YarnForces& forces) const { return assembly_->costs(forces); }

 private:
  std::vector<char> is_end_;  // (num_nodes)
  std::vector<int> coords_;
  DofMap map_;
  std::unique_ptr<Assembly> assembly_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace slipstitch
