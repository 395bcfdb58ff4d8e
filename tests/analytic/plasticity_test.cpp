// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kStiffness = 1e-3, kYield = 0.3, kRelaxation = 2.0, kInstant = 1e-9;

Vec3 turned(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }

struct Pose {
  double t, angle;
};

/// A yarn of three pieces of length 1: the first held, the second turned by a script, the third left to follow.
Simulation turned_yarn(const std::vector<Pose>& script) {
  Scene scene;
  scene.yarns = {straight_yarn(-Vec3::UnitX(), 2.0 * Vec3::UnitX(), 3)};
  scene.yarn.bending_nm2 = kStiffness;
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.plasticity = PlasticityEffect{kYield, kRelaxation};
  scene.handles = {pin(0, 0), pin(0, 1), pin(0, 2)};
  for (const Pose& pose : script)
    scene.handles[2].motion.push_back({pose.t, turned(pose.angle) - turned(0.0), Vec3::Zero()});
  return Simulation(checked_model(scene));
}

/// Angle by which the yarn at its first bend is bent elastically: moment = 2 EI e/W, W = 2.
double elastic_angle(const Simulation& sim, double angle) {
  const Vec3 across(-std::sin(angle), std::cos(angle), 0.0);
  return across.dot(sim.reactions().segment<3>(6)) / kStiffness;
}

void advance_to(Simulation& sim, double t, int steps) {
  const double h = (t - sim.state().t) / steps;
  advance(sim, steps, h, tight(1e-9, 1e-12));
}

TEST(Plasticity, AHeldBendRelaxesToTheYieldAngle) {
  constexpr double kAngle = 1.0, kStep = 0.25;
  Simulation sim = turned_yarn({{0.0, 0.0}, {kInstant, kAngle}});
  advance_to(sim, kInstant, 1);
  EXPECT_NEAR(elastic_angle(sim, kAngle), kAngle, 5e-3);
  for (int n = 1; n <= 40; ++n) {
    advance(sim, kStep, tight(1e-9, 1e-12));
    const double before = (n - 1) * kStep;  // a step feels the set of its start
    const double exact = kYield + (kAngle - kYield) * std::exp(-before / kRelaxation);
    EXPECT_NEAR(elastic_angle(sim, kAngle), exact, 5e-3) << before;
  }
}

TEST(Plasticity, KeepsWhatExceedsTheYieldAngleWhenLetGo) {
  constexpr double kAngle = 1.0, kHeld = 20.0 * kRelaxation, kSet = kAngle - kYield;
  for (const double angle : {kSet, kSet + 0.1, kSet - 0.1}) {
    Simulation sim = turned_yarn({{0.0, 0.0}, {kInstant, kAngle}, {kHeld, kAngle}, {kHeld + kInstant, angle}});
    advance_to(sim, kInstant, 1);
    advance_to(sim, kHeld, 40);
    EXPECT_NEAR(sim.state().set_angle[1], kSet, 2e-3);
    EXPECT_EQ(sim.state().set_angle[2], 0.0);  // the free piece ran straight on
    advance_to(sim, kHeld + kInstant, 1);
    EXPECT_NEAR(elastic_angle(sim, angle), angle - kSet, 2e-3);  // no force at the set, back to it from either side
  }
}

TEST(Plasticity, BelowTheYieldAngleNothingRemains) {
  constexpr double kAngle = 0.95 * kYield;
  Simulation sim = turned_yarn({{0.0, 0.0}, {kInstant, kAngle}});
  advance_to(sim, kInstant, 1);
  advance_to(sim, 50.0 * kRelaxation, 50);
  EXPECT_EQ(sim.state().set_angle, VecX::Zero(4));
  EXPECT_NEAR(elastic_angle(sim, kAngle), kAngle, 1e-9);
}

// A bend that has set altogether presses on its guide no more.
TEST(Plasticity, FrictionFeelsTheForceThatIsLeft) {
  Scene scene;
  scene.yarns.emplace_back().points = {Vec3(-1.0, 0.0, 0.0), Vec3::Zero(), turned(1.0)};
  scene.yarn.bending_nm2 = kStiffness;
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.plasticity = PlasticityEffect{0.0, kRelaxation};
  scene.effects.sliding.emplace();
  scene.effects.sliding_friction.emplace();
  scene.guides = {{0, 1}};
  scene.handles = {pin(0, 0), pin(0, -1)};
  Simulation sim(checked_model(scene));
  const auto limit = [&] { return std::get<SlidingFriction>(sim.forces()).limits().at(0); };
  advance(sim, 1e-6 * kRelaxation, tight(1e-9, 1e-9));
  const double at_first = limit();
  EXPECT_GT(at_first, 1e-4 * kStiffness);
  advance(sim, 20, kRelaxation, tight(1e-9, 1e-9));
  EXPECT_LT(limit(), 0.01 * at_first);
}

TEST(Plasticity, HasTheBendingEnergyWithoutASet) {
  Simulation sim = turned_yarn({{0.0, 0.0}, {kInstant, 0.2}});
  advance_to(sim, kInstant, 1);
  EXPECT_NEAR(sim.energies().at("bending"), kStiffness * 0.2 * 0.2 / 2.0, 1e-9 * kStiffness);
}

}  // namespace
}  // namespace slipstitch::testing
