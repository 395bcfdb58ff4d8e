// SPDX-License-Identifier: MIT
#include "sim/step_objective.h"

#include <gtest/gtest.h>

#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

/// Length of the first piece of yarn 0 before its crossing after some of Newton's largest steps that shorten it.
double arc_after_steps(bool keep_arcs) {
  const Model model = compile(crossed_yarns(), nullptr);
  YarnForces forces = make_forces(model);
  const DofMap map = make_dof_map(model);
  Assembly assembly(forces, map);
  std::map<std::string, double> wall;
  StepObjective objective(forces, map, assembly, model.topology, wall);
  if (keep_arcs) objective.keep_arcs(model.start_q, 0.05, model.yarn.stretch_n);
  const int u = model.topology.arc_coord(2);  // of the crossing, which slides
  VecX y;
  restrict_to_dofs(map, model.start_q, y);
  VecX dy = VecX::Zero(y.size());
  dy[map.dof_of(u)] = -1.0;
  for (int n = 0; n < 6; ++n) y += objective.max_step(y, dy) * dy;
  VecX q;
  expand(map, y, q);
  return (q[u] - q[u - 1]) / (model.start_q[u] - model.start_q[u - 1]);
}

// Yarn whose segment lost its length is stiff without bound: the Newton step would be small at any force.
TEST(StepObjective, KeepsATwentiethOfEveryArcLengthInAStepHoweverManyIterationsItTakes) {
  EXPECT_GE(arc_after_steps(true), 0.05);
  EXPECT_LT(arc_after_steps(true), 0.1);
  EXPECT_LT(arc_after_steps(false), 1e-5);
}

}  // namespace
}  // namespace slipstitch::testing
