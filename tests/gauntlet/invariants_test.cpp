// SPDX-License-Identifier: MIT
// Everything that the gauntlet watches can fail: one planted defect each.
#include "gauntlet/invariants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "gauntlet/case_parts.h"
#include "gauntlet/passages.h"
#include "sim/prepare.h"

namespace slipstitch::gauntlet {
namespace {

/// A step of a hanging swatch, and what may be made of its end.
class OneStep : public ::testing::Test {
 protected:
  OneStep() {
    Scene scene = swatch(4, 4);
    hang(scene);
    sim_ = std::make_unique<Simulation>(prepare(scene).model);
    for (int k = 0; k < 3; ++k) {
      before_ = sim_->state();
      report_ = sim_->step(1.0 / 240.0, {}, {});
    }
    after_ = sim_->state();
  }

  double share(const std::string& name) const {
    const AcceptedStep step{*sim_, before_, after_, report_.newton};
    for (const Invariant& invariant : invariants())
      if (invariant.name == name) return invariant.share(step, Limits{});
    ADD_FAILURE() << "no invariant is called " << name;
    return 0.0;
  }

  /// It holds now, and no more after the defect.
  void expect_sees(const std::string& name, const std::function<void(State&)>& defect) {
    EXPECT_LE(share(name), 1.0) << name;
    defect(after_);
    EXPECT_GT(share(name), 1.0) << name;
  }

  int arc(int visit) const { return sim_->model().topology.arc_coord(visit); }

  std::unique_ptr<Simulation> sim_;
  State before_, after_;
  StepReport report_;
};

TEST_F(OneStep, FiniteSeesANumberThatIsNone) {
  expect_sees("finite", [](State& s) { s.v[7] = std::numeric_limits<double>::quiet_NaN(); });
}

TEST_F(OneStep, OrderSeesYarnThatPassesItself) {
  expect_sees("order", [&](State& s) { std::swap(s.q[arc(20)], s.q[arc(21)]); });
}

TEST_F(OneStep, OrderSeesASegmentThatAllYarnHasLeft) {
  expect_sees("order", [&](State& s) { s.q[arc(20)] = s.q[arc(21)] - 1e-4 * (s.q[arc(21)] - s.q[arc(20)]); });
}

TEST_F(OneStep, StretchSeesASegmentThatIsTooLong) {
  expect_sees("stretch", [](State& s) { s.q[60] += 5e-3; });
}

TEST_F(OneStep, DescentSeesAStepThatDidNotMinimise) {
  expect_sees("descent", [](State& s) { s.q[60] += 1e-4; });
}

TEST_F(OneStep, DescentSeesAStepThatIsNotTaken) {
  EXPECT_LE(share("descent"), 0.0);
  after_.q = before_.q;
  EXPECT_GE(share("descent"), 0.0);
}

TEST_F(OneStep, MomentumSeesWhatNothingGave) {
  expect_sees("momentum", [](State& s) { s.p[31] += 1e-11; });
}

TEST(Invariants, HoldWhereNothingHappens) {
  Scene scene;
  BareYarn yarn;
  for (int i = 0; i <= 4; ++i) yarn.points.push_back({0.25 * i, 0, 0});  // lengths without round-off
  scene.yarns = {yarn};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  Simulation sim(compile(scene, nullptr));
  const State before = sim.state();
  const StepReport report = sim.step(1.0 / 240.0, {}, {});
  ASSERT_TRUE(report.accepted);
  for (const Invariant& invariant : invariants())
    EXPECT_LE(invariant.share({sim, before, sim.state(), report.newton}, Limits{}), 1.0) << invariant.name;
}

/// Two straight yarns that cross in projection, d apart in height.
Model crossing(double d) {
  Scene scene;
  BareYarn a, b;
  for (int i = 0; i <= 4; ++i) {
    a.points.push_back({1e-2 * (i - 2) + 3e-3, 0, 0});
    b.points.push_back({0, 1e-2 * (i - 2) + 4e-3, d});
  }
  scene.yarns = {a, b};
  return compile(scene, nullptr);
}

TEST(Passages, SeesYarnThatGoesThroughYarn) {
  const Model above = crossing(1e-3), below = crossing(-1e-3), near = crossing(1e-5);
  Passages passages(above);
  passages.after_step(above.start_q, near.start_q);
  EXPECT_EQ(passages.count(), 0);
  passages.after_step(near.start_q, below.start_q);
  EXPECT_EQ(passages.count(), 1);
  passages.after_step(below.start_q, below.start_q);
  EXPECT_EQ(passages.count(), 1);
}

}  // namespace
}  // namespace slipstitch::gauntlet
