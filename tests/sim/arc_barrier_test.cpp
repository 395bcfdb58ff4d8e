// SPDX-License-Identifier: MIT
#include "sim/arc_barrier.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/assembly.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

constexpr double kShare = 0.05;

/// The crossing of two yarns, moved along the first until its segment has `left` of its arc length.
struct Crowded {
  Model model = compile(crossed_yarns(), nullptr);
  ArcBarrier barrier;
  int u = model.topology.arc_coord(2);
  double rest = model.start_q[u] - model.start_q[u - 1];

  Crowded() { barrier.keep(model.topology, model.start_q, kShare, model.yarn.stretch_n); }
  VecX at(double left) const {
    VecX q = model.start_q;
    q[u] = q[u - 1] + left * rest;
    return q;
  }
};

TEST(ArcBarrier, ActsBelowTwiceTheFloorAndIsInfiniteThere) {
  const Crowded crowded;
  EXPECT_FALSE(crowded.barrier.active(crowded.at(2.001 * kShare)));
  EXPECT_EQ(crowded.barrier.value(crowded.at(2.001 * kShare)), 0.0);
  EXPECT_TRUE(crowded.barrier.active(crowded.at(1.9 * kShare)));
  double before = 0.0;
  for (const double floors : {1.9, 1.5, 1.1, 1.01, 1.0001}) {
    const double energy = crowded.barrier.value(crowded.at(floors * kShare));
    EXPECT_GT(energy, before) << floors;
    before = energy;
  }
  EXPECT_TRUE(std::isinf(crowded.barrier.value(crowded.at(0.999 * kShare))));
}

TEST(ArcBarrier, HasTheDerivativesOfItsValue) {
  const Crowded crowded;
  const YarnForces forces = make_forces(crowded.model);
  const DofMap map = make_dof_map(crowded.model);
  const Assembly assembly(forces, map);
  const int dof = map.dof_of(crowded.u);
  const auto derivatives = [&](double left, VecX& g) {
    SparseMatrix h{assembly.pattern(), std::vector<double>(assembly.pattern()->row.size(), 0.0)};
    g = VecX::Zero(map.num_dofs);
    crowded.barrier.add_derivatives(crowded.at(left), map, g, h);
    return h.values[static_cast<std::size_t>(h.pattern->slot(dof, dof))];
  };
  for (const double floors : {1.05, 1.3, 1.7, 1.95}) {
    const double left = floors * kShare, step = 1e-6 * left;
    VecX low, high, here;
    derivatives(left - step, low);
    derivatives(left + step, high);
    const double second = derivatives(left, here), way = 2.0 * step * crowded.rest;
    const double slope =
        (crowded.barrier.value(crowded.at(left + step)) - crowded.barrier.value(crowded.at(left - step))) / way;
    EXPECT_NEAR(here[dof], slope, 1e-7 * std::abs(slope)) << floors;
    EXPECT_NEAR(second, (high[dof] - low[dof]) / way, 1e-7 * second) << floors;
    EXPECT_GT(second, 0.0) << floors;
  }
}

}  // namespace
}  // namespace slipstitch::testing
