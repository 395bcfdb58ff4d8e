// SPDX-License-Identifier: MIT
#include <array>

#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

// L = 1, EI = 1; EA so large that stretching stays below the errors tested.
constexpr double kStretch = 1e6;
// Arc length of the segment that holds the wall's direction. Next to nothing, so that the spring at the wall is
// 2 EI/h: with a segment as long as the others the beam would be h/2 too long and the order 1.
constexpr double kGhost = 1e-6;

struct Tip {
  double angle, drop, shortening;  // [rad], in units of L
};

enum class Loading { tip_force, own_weight };

Simulation beam(int pieces, Loading loading, double load) {
  Scene scene;
  BareYarn yarn;
  yarn.points = line(Vec3::Zero(), Vec3::UnitX(), pieces);
  yarn.points.insert(yarn.points.begin(), Vec3(-kGhost, 0.0, 0.0));
  scene.yarns = {yarn};
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1.0, .stretch_n = kStretch, .bending_nm2 = 1.0};
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.handles = {pin(0, 0), pin(0, 1)};
  if (loading == Loading::tip_force) {
    scene.loads = {{YarnPoint{0, -1}, {0.0, -load, 0.0}}};
  } else {
    scene.effects.gravity.emplace().acceleration_m_per_s2 = {0.0, -load, 0.0};
  }
  return Simulation(checked_model(scene));
}

Tip bent(int pieces, Loading loading, double load) {
  Simulation sim = beam(pieces, loading, load);
  advance(sim, 1.0, tight(1e-9, 2e-7));
  const Vec3 end = position(sim, 0, -1), d = end - position(sim, 0, -2),
             before = position(sim, 0, -2) - position(sim, 0, -3);
  const double last = std::atan2(-d.y(), d.x()), previous = std::atan2(-before.y(), before.x());
  return {1.5 * last - 0.5 * previous, -end.y(), 1.0 - end.x()};  // the angle continued to the tip
}

struct Row {
  double load;
  Tip tip;
};

// Inextensible elastica, computed to 12 digits from elliptic integrals.
constexpr std::array<Row, 9> kTipForce = {{
    {0.1, {0.0499542557548, 0.0332953192682, 0.000665399963048}},
    {0.25, {0.124292442114, 0.0827459153544, 0.00411781840998}},
    {0.5, {0.244533647133, 0.162143575658, 0.0159189624708}},
    {1, {0.461351949712, 0.301720773800, 0.0564332362834}},
    {2, {0.781749831557, 0.493457480397, 0.160641720825}},
    {3, {0.986016946711, 0.603253441130, 0.254420184564}},
    {5, {1.21536811761, 0.713791523612, 0.387628360724}},
    {7.5, {1.35592659892, 0.776702000443, 0.489574248523}},
    {10, {1.43028553880, 0.810609024880, 0.554995597754}},
}};

// th'' = -beta (1 - s) cos th, th(0) = 0, th'(1) = 0.
constexpr std::array<Row, 8> kOwnWeight = {{
    {0.5, {0.0831365865624, 0.0623057681503, 0.00222099971934}},
    {1, {0.165115560502, 0.123471401983, 0.00875360465336}},
    {2, {0.321593797669, 0.238506582873, 0.0331070531039}},
    {5, {0.697004777536, 0.495905044622, 0.153342820046}},
    {10, {1.0526431172, 0.700199715514, 0.343646238761}},
    {20, {1.33950154174, 0.829881443439, 0.554767947760}},
    {50, {1.52645315043, 0.907917123477, 0.754985243679}},
    {100, {1.56410732058, 0.937523935396, 0.840776617372}},
}};

void check_row(Loading loading, const Row& row) {
  const Tip coarse = bent(16, loading, row.load), middle = bent(32, loading, row.load),
            fine = bent(64, loading, row.load);
  EXPECT_NEAR(fine.angle, row.tip.angle, 0.005 * row.tip.angle) << row.load;
  EXPECT_NEAR(fine.drop, row.tip.drop, 0.005 * row.tip.drop) << row.load;
  EXPECT_NEAR(fine.shortening, row.tip.shortening, 0.005 * row.tip.shortening) << row.load;
  EXPECT_GE(order(coarse.drop - row.tip.drop, middle.drop - row.tip.drop), 1.8) << row.load;
  EXPECT_GE(order(middle.drop - row.tip.drop, fine.drop - row.tip.drop), 1.8) << row.load;
}

TEST(Cantilever, TipForceFollowsTheElastica) {
  for (const Row& row : kTipForce) check_row(Loading::tip_force, row);
}

TEST(Cantilever, OwnWeightFollowsTheElastica) {
  for (const Row& row : kOwnWeight) check_row(Loading::own_weight, row);
}

}  // namespace
}  // namespace slipstitch::testing
