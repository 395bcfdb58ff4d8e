// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sim/dof_map.h"
#include "solve/sparse_pattern.h"

namespace slipstitch {

/// Keeps yarn in every segment while a step is solved for: below twice its floor f, the arc length D of a segment costs
///   kappa f log_barrier(g/f),  g = D - f < f, kappa = EA,
/// infinite at the floor. One that only cuts Newton steps short lets them shrink to nothing in front of it, whatever
/// the fabric still has to do. No accepted step may end where this has energy: there it would change the model.
class ArcBarrier {
 public:
  /// No segment of `topology` shall go below `share` of what it has at q, nor below a thousandth of its rest length.
  /// stiffness: kappa [N].
  void keep(const Topology& topology, const VecX& q, double share, double stiffness);

  bool active(const VecX& q) const;
  double value(const VecX& q) const;
  void add_derivatives(const VecX& q, const DofMap& map, VecX& g, SparseMatrix& h) const;
  /// Largest share <= a of the way from q by dq that leaves a tenth of the room above every floor.
  double max_step(const VecX& q, const VecX& dq, double a) const;

 private:
  struct Floor {
    int coord = 0;       // of u0; u1 is the next
    double least = 0.0;  // f [m]
  };
  std::vector<Floor> floors_;
  double stiffness_ = 0.0;
};

}  // namespace slipstitch
