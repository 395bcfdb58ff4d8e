// SPDX-License-Identifier: MIT
#include "force/self_collision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "collide/closest_point.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/simulation.h"
#include "support/energy_budget.h"
#include "support/knit_scene.h"

namespace slipstitch {
namespace {

/// Least distance, in yarn diameters, of two segments that were more than a diameter apart at the start and are not
/// joined by a segment. Found on its own, by trying every pair.
double closest_strangers(const Simulation& sim) {
  const Topology& topology = sim.model().topology;
  std::vector<std::array<int, 2>> segments;
  std::set<std::array<int, 2>> joined;
  for (int i = 0; i + 1 < topology.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology.segment_kind[v] == SegmentKind::none) continue;
    segments.push_back({topology.visit_node[v], topology.visit_node[v + 1]});
    joined.insert({topology.visit_node[v], topology.visit_node[v + 1]});
    joined.insert({topology.visit_node[v + 1], topology.visit_node[v]});
  }
  const auto distance = [&](const VecX& q, const std::array<int, 2>& a, const std::array<int, 2>& b) {
    const Vec3 a0 = q.segment<3>(3 * a[0]), a1 = q.segment<3>(3 * a[1]), b0 = q.segment<3>(3 * b[0]),
               b1 = q.segment<3>(3 * b[1]);
    const SegmentPair close = closest_of_segments(a0, a1, b0, b1);
    return (a0 + close.s * (a1 - a0) - b0 - close.t * (b1 - b0)).norm();
  };
  const auto strangers = [&](const std::array<int, 2>& a, const std::array<int, 2>& b) {
    for (int i : a)
      for (int j : b)
        if (i == j || joined.contains({i, j})) return false;
    return true;
  };
  const double diameter = 2.0 * sim.model().yarn.radius_m;
  double least = 1e3;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const double now = distance(sim.state().q, segments[i], segments[j]) / diameter;
      if (now >= least || !strangers(segments[i], segments[j])) continue;
      if (distance(sim.model().start_q, segments[i], segments[j]) > diameter) least = now;
    }
  return least;
}

constexpr double kExcess = 1e-9;  // of the energy about: implicit Euler only loses some

/// Runs for `duration`, with the energy bounded, and returns the least distance of strangers after any step.
double closest_ever(const Scene& scene, double duration) {
  EXPECT_TRUE(check(scene).empty());
  Simulation sim(prepare(scene).model);
  test::EnergyBudget budget(sim);
  double least = 1e3;
  for (double t = 0.0; t < duration - 1e-9; t += 1.0 / 240.0) {
    const StepReport report = sim.step(1.0 / 240.0, {}, {});
    EXPECT_TRUE(report.accepted) << "t = " << t << ": " << to_string(report.newton.status);
    if (!report.accepted) return 0.0;
    least = std::min(least, closest_strangers(sim));
    budget.after_step();
  }
  std::printf("strangers never closer than %.3f diameters; energy %.2e above its bound, %.2e in a step\n", least,
              budget.excess(), budget.worst_step());
  EXPECT_LE(budget.excess(), kExcess);
  EXPECT_LE(budget.worst_step(), kExcess);
  return least;
}

TEST(SelfCollision, IsNotFeltByARelaxedSwatchOrTube) {
  for (bool round : {false, true}) {
    Scene scene = test::knit_scene("stockinette", 6, 12);
    scene.knit->pattern.in_the_round = round;
    scene.effects.self_collision.emplace();
    const Model model = prepare(scene).model;
    SelfCollision contact(model);
    EXPECT_EQ(contact.start_overlaps(), 0);
    State state;
    state.q = model.start_q;
    contact.begin_step({1e-3, state});
    EXPECT_GT(contact.size(), 100);
    double energy = 0.0, force = 0.0;
    for (int k = 0; k < contact.size(); ++k) {
      Vec<12> q, g;
      for (int i = 0; i < 12; ++i) q[i] = model.start_q[contact.coords(k)[static_cast<std::size_t>(i)]];
      energy += contact.eval(k, q, &g, nullptr);
      force += g.norm();
    }
    EXPECT_EQ(energy, 0.0);
    EXPECT_EQ(force, 0.0);
  }
}

/// Two straight yarns of one segment each that cross at right angles, `apart` between their centrelines.
Scene two_yarns(double apart) {
  Scene scene;
  scene.effects.stretch.emplace();
  scene.effects.inertia.emplace();
  scene.effects.self_collision.emplace();
  scene.yarns.resize(2);
  scene.yarns[0].points = {{-5e-4, 0.0, 0.0}, {5e-4, 0.0, 0.0}};
  scene.yarns[1].points = {{0.0, -5e-4, apart}, {0.0, 5e-4, apart}};
  return scene;
}

/// Energy of the yarns of a scene once the second has been lowered to `apart`.
double energy_at(const Scene& scene, double apart) {
  const Model model = compile(scene, nullptr);
  SelfCollision contact(model);
  VecX dq = VecX::Zero(model.start_q.size());
  for (int n : {2, 3}) dq[3 * n + 2] = apart - model.start_q[3 * n + 2];
  contact.watch(model.start_q, dq, 1.0);
  double energy = 0.0;
  const VecX q = model.start_q + dq;
  for (int k = 0; k < contact.size(); ++k) {
    Vec<12> x;
    for (int i = 0; i < 12; ++i) x[i] = q[contact.coords(k)[static_cast<std::size_t>(i)]];
    energy += contact.eval(k, x, nullptr, nullptr);
  }
  return energy;
}

// Points lie beside the crossing, so that the energy begins a little below d: at the middles of the pieces.
TEST(SelfCollision, BeginsADiameterApartBetweenStrangers) {
  const Scene scene = two_yarns(6e-3);
  const double d = 2.0 * scene.yarn.radius_m;
  EXPECT_EQ(SelfCollision(compile(scene, nullptr)).start_overlaps(), 0);
  EXPECT_EQ(energy_at(scene, 1.001 * d), 0.0);
  EXPECT_GT(energy_at(scene, 0.999 * d), 0.0);
}

TEST(SelfCollision, CountsStrangersThatOverlapAtTheStartAndLeavesThemAtRest) {
  const Scene scene = two_yarns(1e-3);
  ASSERT_GT(2.0 * scene.yarn.radius_m, 1e-3);
  EXPECT_EQ(SelfCollision(compile(scene, nullptr)).start_overlaps(), 1);
  EXPECT_EQ(energy_at(scene, 1e-3), 0.0);
  EXPECT_GT(energy_at(scene, 0.97e-3), 0.0);
  const RunSummary summary = run(scene, 1, {});
  EXPECT_EQ(summary.self_collision_start_overlaps, 1) << summary.message;
  Scene off = scene;
  off.effects.self_collision.reset();
  EXPECT_FALSE(run(off, 1, {}).self_collision_start_overlaps.has_value());
}

// Five yarns side by side over one: they touch it one after another, and the last way lifts them all but one.
TEST(SelfCollision, HasTheSameMatrixHoweverItsStencilsCame) {
  Scene scene = two_yarns(6e-3);
  scene.effects.inertia.reset();
  const double d = 2.0 * scene.yarn.radius_m;
  scene.yarns[0].points = {{-1e-2, 0.0, 0.0}, {1e-2, 0.0, 0.0}};
  scene.yarns[1].points = {{-8e-3, -5e-4, 6e-3}, {-8e-3, 5e-4, 6e-3}};
  for (int k = 1; k < 5; ++k) {
    scene.yarns.push_back(scene.yarns[1]);
    for (Vec3& x : scene.yarns.back().points) x.x() += 4e-3 * k;
  }
  const Model model = compile(scene, nullptr);
  YarnForces forces = make_forces(model);
  const DofMap map = make_dof_map(model);
  Assembly kept(forces, map);
  VecX q = model.start_q;
  const auto expect_same = [&] {
    Assembly fresh(forces, map);
    VecX g_kept, g_fresh;
    SparseMatrix h_kept, h_fresh;
    kept.derivatives(forces, q, HessianMode::exact, g_kept, h_kept);
    fresh.derivatives(forces, q, HessianMode::exact, g_fresh, h_fresh);
    EXPECT_GT(g_fresh.norm(), 0.0);
    EXPECT_EQ(g_kept, g_fresh);
    const VecX x = VecX::LinSpaced(map.num_dofs, -1.0, 2.0);
    VecX kept_x, fresh_x;
    multiply(h_kept, x, kept_x);
    multiply(h_fresh, x, fresh_x);
    EXPECT_LT((kept_x - fresh_x).norm(), 1e-12 * fresh_x.norm());
  };
  const auto move = [&](int yarn, double to) {
    VecX dq = VecX::Zero(q.size());
    for (int n : {2 * yarn, 2 * yarn + 1}) dq[3 * n + 2] = to - q[3 * n + 2];
    std::get<SelfCollision>(forces).watch(q, dq, 1.0);
    q += dq;
  };
  State state;
  for (int yarn : {3, 1, 5, 2, 4}) {
    move(yarn, 0.96 * d);
    expect_same();
  }
  for (int yarn : {1, 2, 3, 5}) move(yarn, 3.0 * d);
  state.q = q;
  std::get<SelfCollision>(forces).begin_step({1e-3, state});
  EXPECT_EQ(std::get<SelfCollision>(forces).size(), 1);
  expect_same();
  move(3, 0.96 * d);
  expect_same();
}

Scene curling_swatch() {
  Scene scene = test::knit_scene("stockinette", 18, 6);
  test::use_demo_feel(scene.effects);
  scene.effects.wrapping->alpha = 1.0;  // rolls up within 0.2 s
  scene.knit->noise_m = 1e-6;
  return scene;
}

// Points a radius apart on yarns a diameter thick leave 1.76 radii between centrelines that cross between them.
constexpr double kLeast = 0.88;

TEST(SelfCollision, KeepsASwatchThatRollsUpOutOfItself) {
  Scene scene = curling_swatch();
  EXPECT_LT(closest_ever(scene, 0.25), 0.5);
  scene.effects.self_collision.emplace();
  EXPECT_GT(closest_ever(scene, 0.25), kLeast);
}

TEST(SelfCollision, KeepsTheLayersOfAFoldApart) {
  Scene scene = test::knit_scene("stockinette", 12, 6);
  test::use_demo_feel(scene.effects);
  scene.effects.self_collision.emplace();
  scene.handles = {Handle{Edge::bottom, {}, false}};
  Handle top{Edge::top, {}, false};
  for (int k = 0; k <= 8; ++k) {  // a half turn, over onto the lower half, and then into it
    const double a = kPi * k / 8.0;
    top.motion.push_back(
        {0.05 * k, {0.0, -8e-3 * (1.0 - std::cos(a)), 8e-3 * std::sin(a) + 2e-3 * k / 8.0}, {a, 0.0, 0.0}});
  }
  top.motion.push_back({0.5, {0.0, -16e-3, -1e-3}, {kPi, 0.0, 0.0}});
  scene.handles.push_back(top);
  EXPECT_GT(closest_ever(scene, 0.5), kLeast);
}

}  // namespace
}  // namespace slipstitch
