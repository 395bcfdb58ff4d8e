// SPDX-License-Identifier: MIT
// What holds for every case of the gauntlet, as it is.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>

#include "gauntlet/gauntlet_case.h"
#include "gauntlet/moved_rigidly.h"
#include "sim/prepare.h"
#include "sim/simulation.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kOfExtent = 1e-10;
constexpr int kMaxHalvings = 10;
constexpr int kStepsBefore = 15;  // the first ones leave a flat start that is a saddle: which way is up to round-off
constexpr double kTolerance = 1e-9;

/// One accepted step, halved until it is; h [s] is that of the step then.
void step(Simulation& sim, const FixedNumerics& numerics, double& h) {
  for (int k = 0; k < kMaxHalvings; ++k, h *= 0.5)
    if (sim.step(h, numerics, {}).accepted) return;
  ADD_FAILURE() << "no step";
}

class EveryCase : public ::testing::TestWithParam<GauntletCase> {
 protected:
  Model model() const {
    Prepared prepared = prepare(scene_of(GetParam(), {}));
    EXPECT_FALSE(prepared.failure) << *prepared.failure;
    if (GetParam().change) GetParam().change(prepared.model);
    return std::move(prepared.model);
  }
  /// A model that starts where the case is after some steps.
  Model under_way() const {
    Model model = this->model();
    Simulation sim(model);
    for (int k = 0; k < kStepsBefore; ++k) {
      double h = numerics().time_step_s;
      step(sim, numerics(), h);
    }
    model.start_q = sim.state().q;
    model.start_v = sim.state().v;
    return model;
  }
  FixedNumerics numerics() const { return std::get<FixedNumerics>(scene_of(GetParam(), {}).numerics); }
};

double extent(const VecX& q, int nodes) {
  Eigen::AlignedBox3d box;
  for (int n = 0; n < nodes; ++n) box.extend(Vec3(q.segment<3>(3 * n)));
  return box.diagonal().norm();
}

TEST_P(EveryCase, StepsAlikeWhereverItIsAndHoweverItIsTurned) {
  const RigidMove move{Mat3(Eigen::AngleAxisd(0.7, Vec3(1.0, -2.0, 0.5).normalized())), Vec3(0.03, -0.02, 0.05)};
  const Model here = under_way();
  Simulation sim(here), moved(moved_rigidly(here, move));
  FixedNumerics tight = numerics();
  tight.velocity_tolerance_m_per_s = kTolerance;  // or what Newton leaves would be seen
  double h = tight.time_step_s;
  step(sim, tight, h);
  ASSERT_TRUE(moved.step(h, tight, {}).accepted);
  const int nodes = here.topology.num_nodes;
  double worst = 0.0;
  for (int n = 0; n < nodes; ++n)
    worst = std::max(worst, (move.point(sim.state().q.segment<3>(3 * n)) - moved.state().q.segment<3>(3 * n)).norm());
  const double size = extent(here.start_q, nodes);
  std::printf("%s: %.1e of its extent apart\n", GetParam().name.c_str(), worst / size);
  EXPECT_LE(worst, kOfExtent * size);
}

TEST_P(EveryCase, IsTheSameBitForBitWhenItIsRunAgain) {
  const Model start = model();
  double h = numerics().time_step_s;
  Simulation a(start), b(start);
  for (int k = 0; k < 3; ++k) {
    double other = h;
    step(a, numerics(), h);
    step(b, numerics(), other);
    ASSERT_EQ(other, h);
    ASSERT_EQ(a.state().q, b.state().q);
    ASSERT_EQ(a.state().p, b.state().p);
  }
}

INSTANTIATE_TEST_SUITE_P(Gauntlet, EveryCase, ::testing::ValuesIn(gauntlet_cases()), [](const auto& test) {
  std::string name = test.param.name;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

}  // namespace
}  // namespace slipstitch::gauntlet
