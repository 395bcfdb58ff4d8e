// SPDX-License-Identifier: MIT
// What is off is not there: shown by counting.
#include <set>

#include "sim/run.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

std::set<std::string> terms(const EffectCosts& costs) {
  std::set<std::string> names;
  for (const auto& [name, cost] : costs) {
    names.insert(name);
    EXPECT_GT(cost.stencils, 0) << name;
    EXPECT_GT(cost.bytes, 0) << name;
  }
  return names;
}

EffectCosts costs_of(const Scene& scene) { return Simulation(compile(scene, nullptr)).effect_costs(); }

TEST(EffectCost, ATermWhoseEffectIsOffIsAbsent) {
  Scene scene = hanging_yarn();
  EXPECT_EQ(terms(costs_of(scene)), (std::set<std::string>{"inertia", "gravity", "stretch", "bending"}));
  scene.effects.bending.reset();
  scene.effects.gravity.reset();
  scene.effects.air_drag.emplace();
  EXPECT_EQ(terms(costs_of(scene)), (std::set<std::string>{"inertia", "stretch", "air_drag"}));
}

// Four segments, five nodes, the first held: 4 blocks of 6 on the diagonal, 3 of 9 beside it; bends reach one node on.
TEST(EffectCost, CountsEveryMatrixEntryOfATermOnce) {
  const EffectCosts costs = costs_of(hanging_yarn());
  EXPECT_EQ(costs.at("stretch").stencils, 4);
  EXPECT_EQ(costs.at("stretch").nonzeros, 4 * 6 + 3 * 9);
  EXPECT_EQ(costs.at("bending").stencils, 3);
  EXPECT_EQ(costs.at("bending").nonzeros, 4 * 6 + 3 * 9 + 2 * 9);
  Simulation sim(compile(hanging_yarn(), nullptr));
  EXPECT_EQ(costs.at("bending").nonzeros, sim.num_nonzeros());
}

TEST(EffectCost, WithoutSlidingThereIsNoArcLengthAmongTheUnknowns) {
  Scene scene = crossed_yarns();
  Simulation sliding(compile(scene, nullptr));
  scene.effects.sliding.reset();
  Simulation glued(compile(scene, nullptr));
  const int free_nodes = 9 - 1;  // ten points, two of them one node; one is held
  EXPECT_EQ(glued.num_dofs(), 3 * free_nodes);
  EXPECT_EQ(sliding.num_dofs(), 3 * free_nodes + 2);
  EXPECT_LT(glued.effect_costs().at("stretch").nonzeros, sliding.effect_costs().at("stretch").nonzeros);
  EXPECT_FALSE(glued.effect_costs().contains("damping_sliding"));
  EXPECT_FALSE(glued.effect_costs().contains("sliding"));
  EXPECT_EQ(sliding.effect_costs().at("sliding").dofs, 2);
  // Glued, the matrix is that of the positions.
  EXPECT_EQ(sliding.effect_costs().at("sliding").nonzeros, sliding.num_nonzeros() - glued.num_nonzeros());
}

TEST(EffectCost, WithoutWrappingNoTwelveByTwelveBlocks) {
  Scene scene = free_swatch(3, 3);
  const auto nonzeros = [&] {
    Simulation sim(compile(scene, nullptr));
    EXPECT_EQ(sim.effect_costs().contains("wrapping"), scene.effects.wrapping.has_value());
    return sim.num_nonzeros();
  };
  scene.effects.damping.reset();
  const int with = nonzeros();
  scene.effects.wrapping.reset();
  EXPECT_LT(nonzeros(), with);
}

TEST(EffectCost, WithoutPlasticityThereIsNoSet) {
  Scene scene = hanging_yarn();
  EXPECT_EQ(Simulation(compile(scene, nullptr)).state().set_angle.size(), 0);
  scene.effects.plasticity.emplace();
  EXPECT_EQ(Simulation(compile(scene, nullptr)).state().set_angle.size(), 5);
}

TEST(EffectCost, OfAnEffectThatActsInOtherTermsIsThereOnlyWhenItIsOn) {
  Scene scene = hanging_yarn();
  scene.effects.air_drag.emplace();
  const EffectCosts off = costs_of(scene);
  for (const char* effect : {"plasticity", "shrinkage", "wind"}) EXPECT_FALSE(off.contains(effect)) << effect;
  scene.effects.plasticity.emplace();
  scene.effects.shrinkage.emplace().keyframes = {{1.0, 0.9}};
  scene.effects.wind.emplace().velocity_m_per_s = {1.0, 0.0, 0.0};
  const EffectCosts on = costs_of(scene);
  EXPECT_EQ(on.at("plasticity").stencils, on.at("bending").stencils);
  EXPECT_EQ(on.at("plasticity").bytes, 3 * 2 * 8);
  EXPECT_EQ(on.at("shrinkage").stencils, 4);
  EXPECT_EQ(on.at("wind").stencils, on.at("air_drag").stencils);
}

// Nothing that could touch is looked for where nothing may touch, and nothing is there to look for it in.
TEST(EffectCost, WithoutCollidersAndSelfCollisionNothingIsSearchedFor) {
  Scene scene = hanging_yarn();
  scene.duration_s = 0.05;
  for (const auto& [term, cost] : run(scene, 1, {}).effect_cost) EXPECT_EQ(cost.searches, 0) << term;
  scene.effects.self_collision.emplace();
  Collider far;
  far.shape = Sphere{{10.0, 0.0, 0.0}, 0.1};
  scene.effects.colliders.emplace().colliders = {far};
  const EffectCosts on = run(scene, 1, {}).effect_cost;
  for (const char* term : {"colliders", "self_collision"}) {
    ASSERT_TRUE(on.contains(term)) << term;
    EXPECT_GT(on.at(term).searches, 0) << term;
    EXPECT_GT(on.at(term).bytes, 0) << term;
    EXPECT_EQ(on.at(term).stencils, 0) << term;
  }
}

TEST(EffectCost, IsInTheSummaryWithItsEvaluations) {
  Scene scene = hanging_yarn();
  scene.duration_s = 0.1;
  const RunSummary summary = run(scene, 1, {});
  ASSERT_EQ(summary.status, RunStatus::succeeded);
  EXPECT_EQ(terms(summary.effect_cost), (std::set<std::string>{"inertia", "gravity", "stretch", "bending"}));
  const EffectCost& stretch = summary.effect_cost.at("stretch");
  // The loose end is next to one segment and one bend: 4 M + E and 3 M + E evaluations, M of the whole, E of the end.
  const long whole = stretch.evaluations - summary.effect_cost.at("bending").evaluations;
  EXPECT_GE(whole, summary.newton_iterations);
  EXPECT_GE(stretch.evaluations, 4 * whole);
  EXPECT_EQ(stretch.evaluations, summary.effect_cost.at("inertia").evaluations);
  scene.duration_s = 0.0;
  EXPECT_EQ(run(scene, 1, {}).effect_cost.at("stretch").evaluations, 0);
}

}  // namespace
}  // namespace slipstitch::testing
