// SPDX-License-Identifier: MIT
#include "sim/loose_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "model/model.h"
#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

Model hanging_model() { return compile(hanging_yarn(), nullptr); }

struct Hanging {
  Model model = hanging_model();
  YarnForces forces = make_forces(model);
  DofMap map = make_dof_map(model);
  LooseEnds ends{model.topology, forces, map};
  State start{0.0, model.start_q, model.start_v, VecX::Zero(model.start_q.size()), model.start_q.tail(5), VecX(), {}};

  Hanging() {
    std::apply([&](auto&... term) { (term.begin_step(StepContext{1e-2, start}), ...); }, forces);
  }
  double energy(const VecX& q) { return Assembly(forces, map).value(forces, q); }
};

TEST(LooseEnds, AreTheFreeEndsOnly) {
  Hanging hanging;
  EXPECT_FALSE(hanging.ends.contains_node(0));  // held
  EXPECT_TRUE(hanging.ends.contains_node(4));
  EXPECT_EQ(hanging.ends.coords(), (std::vector<int>{12, 13, 14}));
}

TEST(LooseEnds, SettleWhereNothingPullsThemAndLeaveTheRest) {
  Hanging hanging;
  VecX q = hanging.model.start_q;
  q[3 * 3 + 1] -= 0.02;  // the neighbour moves down, the end has to turn by 0.4 rad
  const VecX before = q;
  EXPECT_LE(hanging.ends.settle(hanging.forces, q, before, 1e-12), 1e-12);
  EXPECT_EQ(q.head(12), before.head(12));
  EXPECT_LT(hanging.energy(q), hanging.energy(before));
  VecX gradient = VecX::Zero(q.size());
  std::apply([&](const auto&... term) { (add_full_gradient(term, q, {}, gradient), ...); }, hanging.forces);
  EXPECT_LT(gradient.segment(12, 3).norm(), 1e-9 * gradient.norm() + 1e-12);
}

TEST(LooseEnds, StartFromWhicheverPlaceIsLower) {
  Hanging hanging;
  VecX q = hanging.model.start_q, before = q;
  q[12] += 0.5;  // torn away
  hanging.ends.settle(hanging.forces, q, before, 1e-12);
  VecX from_before = before;
  hanging.ends.settle(hanging.forces, from_before, before, 1e-12);
  EXPECT_LT((q - from_before).norm(), 1e-10);
}

// The end is bent down by 45 degrees; a sphere stands between it and where it was.
TEST(LooseEnds, DoNotStartFromBehindASphere) {
  const auto turned = [](double angle, double length) {
    return Vec3(0.15 + length * std::cos(angle), -length * std::sin(angle), 0.0);
  };
  for (const Vec3& aside : {Vec3(0.0, 0.0, 0.0), Vec3(0.0, 0.0, 0.1)}) {
    Scene scene = hanging_yarn();
    scene.effects.colliders.emplace().colliders = {
        {Sphere{turned(kPi / 8.0, 0.04) + aside, 0.012}, 0.3, {}, DynamicBody{1.0}}};
    Model model = compile(scene, nullptr);
    YarnForces forces = make_forces(model);
    LooseEnds ends(model.topology, forces, make_dof_map(model));
    const State start{
        0.0, model.start_q, model.start_v, VecX::Zero(model.start_q.size()), model.start_q.tail(5), VecX(), {}};
    std::apply([&](auto&... term) { (term.begin_step(StepContext{1e-2, start}), ...); }, forces);
    VecX q = model.start_q;
    q.segment<3>(12) = turned(kPi / 4.0, 0.05);
    ends.settle(forces, q, model.start_q, 1e-9);
    if (aside.isZero()) {
      EXPECT_LT(q[13], -0.025);
    } else {
      EXPECT_GT(q[13], -0.005);
    }
  }
}

TEST(LooseEnds, SayWhenTheyCouldNotBeSolvedFor) {
  Hanging hanging;
  VecX q = hanging.model.start_q;
  q[3] = std::numeric_limits<double>::quiet_NaN();  // of the neighbour, so that no value is finite
  q[9] = q[3];
  EXPECT_EQ(hanging.ends.settle(hanging.forces, q, q, 1e-12), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace slipstitch::testing
