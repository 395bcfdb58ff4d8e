// SPDX-License-Identifier: MIT
#include "force/shrinkage.h"

#include <array>

#include "analytic_helpers.h"
#include "model/effect_list.h"
#include "model/select.h"
#include "sim/frame.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "support/knit_scene.h"

namespace slipstitch::testing {
namespace {

TEST(LengthFactor, IsLinearFromOneAtTheStartAndHeldAfterTheLastKeyframe) {
  const std::vector<LengthKeyframe> late{{1.0, 0.9}, {3.0, 1.1}}, at_once{{0.0, 0.8}};
  for (const auto& [t, factor] : {std::pair(0.0, 1.0), {0.5, 0.95}, {1.0, 0.9}, {2.0, 1.0}, {3.0, 1.1}, {9.0, 1.1}})
    EXPECT_NEAR(length_factor(late, t), factor, 1e-15) << t;
  EXPECT_EQ(length_factor(at_once, 0.0), 0.8);
  EXPECT_EQ(length_factor(std::vector<LengthKeyframe>(), 5.0), 1.0);
}

// EA (|d|/(factor D) - 1), and what a frame says of it.
TEST(Shrinkage, AHeldStraightYarnIsTight) {
  constexpr double kFactor = 0.98, kTension = 68.0 * (1.0 / kFactor - 1.0);
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {0.3, 0.0, 0.0}, 6)};
  scene.yarn.stretch_n = 68.0;
  scene.effects.stretch.emplace();
  scene.effects.shrinkage.emplace().keyframes = {{1.0, kFactor}};
  scene.handles = {pin(0, 0), pin(0, -1)};
  Simulation sim(checked_model(scene));
  advance(sim, 2, 0.5, tight(1e-9, 1e-11));
  EXPECT_NEAR(sim.reactions()[0], -kTension, 1e-9);
  EXPECT_NEAR(sim.reactions()[18], kTension, 1e-9);
  EXPECT_NEAR(sim.energies().at("stretch"), 0.5 * kTension * (1.0 / kFactor - 1.0) * kFactor * 0.3, 1e-12);
  const FrameHeader header{sim.model().topology, scene.yarn, 1.0, 2, scene.effects.shrinkage->keyframes};
  const Frame frame{1, sim.state().t, sim.state().q};
  EXPECT_NEAR(derive(header, frame, frame).tension_n[2], kTension, 1e-9);
}

TEST(Shrinkage, StretchIsReportedAgainstTheRestLength) {
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {0.3, 0.0, 0.0}, 6)};
  scene.effects.stretch.emplace();
  scene.effects.shrinkage.emplace().keyframes = {{1.0, 0.98}};
  scene.handles = {pin(0, 0), pin(0, -1)};
  scene.numerics = FixedNumerics{.time_step_s = 0.5};
  scene.frames_per_s = 1.0;
  EXPECT_NEAR(run(scene, 1, {}).max_stretch.value_or(0.0), 1.0 / 0.98, 1e-9);
}

// Over a guide that turns it by a right angle: mu |T t1 + T t2| = mu T sqrt(2), T of the start of the step.
TEST(Shrinkage, FrictionFeelsTheTension) {
  constexpr double kFactor = 0.97, kMu = 0.3;
  Scene scene;
  scene.yarns.emplace_back().points = {Vec3(0.1, 0.0, 0.0), Vec3::Zero(), Vec3(0.0, 0.1, 0.0)};
  scene.effects.stretch.emplace();
  scene.effects.sliding.emplace();
  scene.effects.sliding_friction.emplace().coefficient = kMu;
  scene.effects.shrinkage.emplace().keyframes = {{1.0, kFactor}};
  scene.guides = {{0, 1}};
  scene.handles = {pin(0, 0), pin(0, -1)};
  Simulation sim(checked_model(scene));
  advance(sim, 3, 0.5, tight(1e-9, 1e-9));
  const double tension = scene.yarn.stretch_n * (1.0 / kFactor - 1.0);
  EXPECT_NEAR(std::get<SlidingFriction>(sim.forces()).limits().at(0) / (kMu * tension * std::sqrt(2.0)), 1.0, 1e-9);
}

TEST(Shrinkage, AFreeYarnTakesOnItsNewLength) {
  for (const double factor : {0.9, 1.15}) {
    Scene scene;
    scene.yarns = {straight_yarn(Vec3::Zero(), {0.1, 0.05, 0.0}, 5)};
    scene.effects.inertia.emplace();
    scene.effects.stretch.emplace();
    scene.effects.shrinkage.emplace().keyframes = {{0.1, factor}};
    scene.effects.damping.emplace().stretch_ns = 1e-2;
    Simulation sim(checked_model(scene));
    advance(sim, 106, 1e-3, tight(1e-7, 0.0));
    const double length = (position(sim, 0, -1) - position(sim, 0, 0)).norm();
    EXPECT_NEAR(length / (factor * std::hypot(0.1, 0.05)), 1.0, 1e-6);
  }
}

/// Distances of opposite edges of a free swatch, along the courses and along the wales.
std::array<double, 2> extent(const Simulation& sim) {
  const auto centre = [&](Edge edge) {
    Vec3 sum = Vec3::Zero();
    const std::vector<int> nodes = select_nodes(edge, sim.model().topology);
    for (int n : nodes) sum += sim.state().q.segment<3>(3 * n);
    return Vec3(sum / static_cast<double>(nodes.size()));
  };
  return {(centre(Edge::right) - centre(Edge::left)).norm(), (centre(Edge::top) - centre(Edge::bottom)).norm()};
}

// Bending, jamming and wrapping depend on angles and arc lengths alone, so the rest shape scales with the yarn.
TEST(Shrinkage, AFreeSwatchShrinksInBothDirections) {
  constexpr double kFactor = 0.85;
  const auto settled = [](bool shrinks) {
    Scene scene = test::knit_scene("stockinette", 4, 4);
    test::use_demo_feel(scene.effects);
    remove_effect(scene.effects, *find_effect("sliding"));
    if (shrinks) scene.effects.shrinkage.emplace().keyframes = {{0.2, kFactor}};
    EXPECT_TRUE(check(scene).empty());
    Simulation sim(prepare(scene, {}).model);
    advance(sim, 100, 1e-2, FixedNumerics{});
    return extent(sim);
  };
  const auto plain = settled(false), shrunk = settled(true);
  EXPECT_NEAR(shrunk[0] / plain[0], kFactor, 5e-3);
  EXPECT_NEAR(shrunk[1] / plain[1], kFactor, 5e-3);
}

}  // namespace
}  // namespace slipstitch::testing
