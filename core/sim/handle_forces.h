// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "math/types.h"

namespace slipstitch {

class Simulation;

/// What holding one handle took. NaN: not measured.
struct HandleForce {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Vec3 reaction_n = Vec3::Constant(kNone);  // of its supports on the fabric at the end [N]
  double max_reaction_n = kNone;            // largest magnitude of any step
  double max_reaction_t_s = kNone;          // when
};

/// Measures, step by step, the forces with which the handles of a scene hold the fabric. Only stencils that touch a
/// handle are evaluated.
class HandleForces {
 public:
  HandleForces(const Simulation& sim, std::size_t num_handles);

  bool empty() const { return total_.empty(); }
  /// After an accepted step: force per handle of the scene [N]; 0 where a handle holds no node that others do not.
  const std::vector<Vec3>& observe(const Simulation& sim);
  const std::vector<HandleForce>& report() const { return report_; }

 private:
  std::vector<char> held_;   // per full coordinate; empty without handles
  std::vector<int> handle_;  // per node, -1: none (num_nodes)
  VecX gradient_;            // scratch (num_coords)
  std::vector<Vec3> total_;  // (num_handles)
  std::vector<HandleForce> report_;
};

}  // namespace slipstitch
