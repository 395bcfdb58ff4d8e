// SPDX-License-Identifier: MIT
#include "sim/arc_barrier.h"

#include <algorithm>

#include "math/log_barrier.h"

namespace slipstitch {
namespace {

constexpr double kLeastArc = 1e-3;  // of a segment's rest length
constexpr double kLeastRoom = 0.1;  // of that above a floor, after one Newton step

}  // namespace

void ArcBarrier::keep(const Topology& topology, const VecX& q, double share, double stiffness) {
  floors_.clear();
  stiffness_ = stiffness;
  for (int i = 0; i + 1 < topology.num_visits(); ++i) {
    if (topology.segment_kind[static_cast<std::size_t>(i)] == SegmentKind::none) continue;
    const int u0 = topology.arc_coord(i);
    const double arc = q[u0 + 1] - q[u0];
    floors_.push_back({u0, std::max(share * arc, std::min(kLeastArc * rest_length(topology, i), 0.25 * arc))});
  }
}

bool ArcBarrier::active(const VecX& q) const {
  return std::any_of(floors_.begin(), floors_.end(), [&](const Floor& floor) {
    return q[floor.coord + 1] - q[floor.coord] < 2.0 * floor.least;
  });
}

double ArcBarrier::value(const VecX& q) const {
  double sum = 0.0;
  for (const Floor& floor : floors_) {
    const double gap = q[floor.coord + 1] - q[floor.coord] - floor.least;
    if (gap < floor.least) sum += stiffness_ * floor.least * log_barrier(gap / floor.least).f;
  }
  return sum;
}

void ArcBarrier::add_derivatives(const VecX& q, const DofMap& map, VecX& g, SparseMatrix& h) const {
  for (const Floor& floor : floors_) {
    const double gap = q[floor.coord + 1] - q[floor.coord] - floor.least;
    if (gap >= floor.least) continue;
    const Jet2 b = log_barrier(gap / floor.least);
    const int d0 = map.dof_of(floor.coord), d1 = map.dof_of(floor.coord + 1);
    const auto entry = [&](int r, int c) -> double& {
      return h.values[static_cast<std::size_t>(h.pattern->slot(std::max(r, c), std::min(r, c)))];
    };
    const double force = stiffness_ * b.d, spring = stiffness_ / floor.least * b.dd;
    if (d0 >= 0) g[d0] -= force, entry(d0, d0) += spring;
    if (d1 >= 0) g[d1] += force, entry(d1, d1) += spring;
    if (d0 >= 0 && d1 >= 0) entry(d0, d1) -= spring;
  }
}

double ArcBarrier::max_step(const VecX& q, const VecX& dq, double a) const {
  for (const Floor& floor : floors_) {
    const double above = q[floor.coord + 1] - q[floor.coord] - floor.least;
    const double change = dq[floor.coord + 1] - dq[floor.coord];
    if (above + a * change < kLeastRoom * above) a = std::max(0.0, (1.0 - kLeastRoom) * above / -change);
  }
  return a;
}

}  // namespace slipstitch
