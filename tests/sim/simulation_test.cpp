// SPDX-License-Identifier: MIT
#include "sim/simulation.h"

#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

void expect_same(const State& a, const State& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.p, b.p);
  EXPECT_EQ(a.anchor, b.anchor);
}

TEST(Simulation, KeepsItsStateWhenAStepIsRejected) {
  Scene scene = crossed_yarns();
  scene.effects.sliding_friction.emplace();
  Simulation sim(compile(scene, nullptr)), untouched(compile(scene, nullptr));
  for (Simulation* s : {&sim, &untouched}) ASSERT_TRUE(s->step(1e-3, FixedNumerics{}, {}).accepted);
  FixedNumerics hopeless;
  hopeless.max_newton_iterations = 1;
  hopeless.velocity_tolerance_m_per_s = 1e-12;
  const StepReport report = sim.step(0.05, hopeless, {});
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.newton.status, NewtonStatus::too_many_iterations);
  expect_same(sim.state(), untouched.state());
  // and it goes on as if nothing had happened
  for (Simulation* s : {&sim, &untouched}) ASSERT_TRUE(s->step(1e-3, FixedNumerics{}, {}).accepted);
  expect_same(sim.state(), untouched.state());
}

TEST(Simulation, KeepsItsStateWhenCancelledWithinOneIteration) {
  Simulation sim(compile(crossed_yarns(), nullptr));
  const State before = sim.state();
  int polls = 0;
  const StepReport report = sim.step(0.01, FixedNumerics{}, [&] { return ++polls >= 2; });
  EXPECT_EQ(report.newton.status, NewtonStatus::cancelled);
  EXPECT_FALSE(report.accepted);
  EXPECT_EQ(report.newton.iterations, 1);
  expect_same(sim.state(), before);
}

TEST(Simulation, BuildsNothingForEffectsThatAreOff) {
  Scene scene = crossed_yarns();
  scene.effects = {};
  const Model model = compile(scene, nullptr);
  YarnForces forces = make_forces(model);
  const int stencils = std::apply([](const auto&... term) { return (0 + ... + term.size()); }, forces);
  EXPECT_EQ(stencils, 0);
  Simulation sim(compile(scene, nullptr));
  EXPECT_EQ(sim.num_dofs(), 24);
  EXPECT_EQ(sim.num_nonzeros(), 24);  // the diagonal alone
  EXPECT_TRUE(sim.energies().empty());
  EXPECT_TRUE(sim.quasi_static());
}

TEST(Simulation, ReportsTheEnergiesOfListedPotentialsOnly) {
  Simulation sim(compile(hanging_yarn(), nullptr));
  std::vector<std::string> names;
  for (const auto& [name, energy] : sim.energies()) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"bending", "gravity", "kinetic", "stretch"}));
}

TEST(Simulation, ReactionsCarryTheWeightAtRest) {
  Scene scene = hanging_yarn();
  scene.effects.inertia.reset();
  scene.handles = {held(0, 0), held(0, -1)};
  Simulation sim(compile(scene, nullptr));
  FixedNumerics numerics;
  numerics.max_newton_iterations = 500;
  numerics.force_tolerance_n = 1e-12;
  ASSERT_TRUE(sim.step(1.0, numerics, {}).accepted);
  const VecX reactions = sim.reactions();
  const Vec3 first = reactions.segment<3>(0), last = reactions.segment<3>(12);
  const double weight = 0.2 * 1e-2 * 9.81;
  EXPECT_NEAR(first.y(), 0.5 * weight, 1e-10);
  EXPECT_NEAR(last.y(), 0.5 * weight, 1e-10);
  EXPECT_LT(first.x(), -1e-4);  // the yarn pulls its ends together
  EXPECT_NEAR(first.x() + last.x(), 0.0, 1e-10);
  for (int n = 1; n < 4; ++n) EXPECT_EQ(reactions.segment<3>(3 * n), Vec3::Zero());
}

TEST(Simulation, DividesALoadOverItsNodes) {
  Scene scene = hanging_yarn();
  scene.effects.inertia.reset();
  scene.effects.gravity.reset();
  scene.loads = {{AllNodes{}, {1.0, 0.0, 0.0}}};
  Simulation sim(compile(scene, nullptr));
  FixedNumerics numerics;
  numerics.force_tolerance_n = 1e-11;
  ASSERT_TRUE(sim.step(1.0, numerics, {}).accepted);
  EXPECT_NEAR(sim.reactions()[0], -1.0, 1e-9);
  EXPECT_NEAR(sim.state().q[12] - sim.state().q[9], 0.05 * (1.0 + 0.2 / 5.0), 1e-9);
}

}  // namespace
}  // namespace slipstitch::testing
