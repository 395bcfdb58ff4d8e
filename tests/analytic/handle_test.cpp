// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"
#include "sim/run.h"

namespace slipstitch::testing {
namespace {

constexpr double kGravity = 9.81;

RunSummary measured(const Scene& scene, const RunHooks& hooks = {}) {
  for (const Issue& issue : check(scene)) ADD_FAILURE() << issue.path << ": " << issue.expected;
  RunSummary summary = run(scene, 1, hooks);
  EXPECT_EQ(summary.status, RunStatus::succeeded) << summary.message;
  return summary;
}

/// Sags between two pins, quasi-static; the second one climbs.
Scene catenary() {
  constexpr int kPieces = 40;
  Scene scene;
  BareYarn yarn;
  for (int i = 0; i <= kPieces; ++i) {
    const double s = static_cast<double>(i) / kPieces;
    yarn.points.push_back({s, -0.8 * s * (1.0 - s), 0.0});
    yarn.arc_lengths_m.push_back(1.2 * s);
  }
  scene.yarns = {yarn};
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 0.5, .stretch_n = 500.0, .bending_nm2 = 1e-6};
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  scene.handles = {pin(0, 0), pin(0, -1)};
  scene.handles[1].motion = {{1.0, {0.0, 0.3, 0.0}, Vec3::Zero()}};
  scene.duration_s = 1.0;
  scene.frames_per_s = 4.0;
  scene.numerics = FixedNumerics{.time_step_s = 0.25, .force_tolerance_n = 1e-9, .max_newton_iterations = 1000};
  return scene;
}

/// Where the far end of an elastic catenary is, hung with a force (h, v) [N] on its near end. H. M. Irvine, "Cable
/// Structures", MIT Press 1981, chapter 1: rest length l [m], weight w [N/m] of it, stiffness ea [N].
Vec3 end_of_catenary(double h, double v, double l, double w, double ea) {
  const double a = v / h, b = (v + w * l) / h;
  return {h * l / ea + h / w * (std::asinh(b) - std::asinh(a)),
          l / ea * (v + 0.5 * w * l) + h / w * (std::hypot(1.0, b) - std::hypot(1.0, a)), 0.0};
}

TEST(Handle, ReactionsOfACatenaryCarryItsWeight) {
  const RunSummary summary = measured(catenary());
  ASSERT_EQ(summary.handles.size(), 2U);
  const Vec3 low = summary.handles[0].reaction_n, high = summary.handles[1].reaction_n;
  EXPECT_LT((low + high - Vec3(0.0, 0.5 * 1.2 * kGravity, 0.0)).norm(), 1e-7);
  EXPECT_GT(high.y(), low.y() + 0.1);  // the higher end carries more
  EXPECT_LT(low.x(), -0.1);            // and they pull apart
  const Vec3 end = end_of_catenary(-low.x(), -low.y(), 1.2, 0.5 * kGravity, 500.0);
  EXPECT_LT((end - Vec3(1.0, 0.3, 0.0)).norm(), 1e-3) << end.transpose();
  EXPECT_NEAR(summary.handles[1].max_reaction_n, high.norm(), 1e-12);
  EXPECT_NEAR(summary.handles[1].max_reaction_t_s, 1.0, 1e-9);
}

/// A straight yarn drawn out with a constant velocity.
Scene drawn_out(double velocity) {
  Scene scene;
  scene.yarns = {straight_yarn(Vec3::Zero(), {0.5, 0.0, 0.0}, 5)};
  scene.yarn.stretch_n = 40.0;
  scene.effects.stretch.emplace();
  scene.handles = {pin(0, 0), pin(0, -1)};
  scene.handles[1].velocity_m_per_s = Vec3(velocity, 0.0, 0.0);
  scene.duration_s = 1.0;
  scene.frames_per_s = 10.0;
  scene.numerics = FixedNumerics{.time_step_s = 0.1, .force_tolerance_n = 1e-10, .max_newton_iterations = 1000};
  return scene;
}

TEST(Handle, APulledStraightYarnGivesStiffnessTimesStrain) {
  int steps = 0;
  RunHooks hooks;
  hooks.on_reactions = [&](double t, const std::vector<Vec3>& forces) {
    ++steps;
    ASSERT_EQ(forces.size(), 2U);
    const Vec3 exact(40.0 * 0.02 * t / 0.5, 0.0, 0.0);
    EXPECT_LT((forces[1] - exact).norm(), 1e-8) << t;
    EXPECT_LT((forces[0] + exact).norm(), 1e-8) << t;
  };
  const RunSummary summary = measured(drawn_out(0.02), hooks);
  EXPECT_EQ(steps, 10);
  EXPECT_NEAR(summary.handles[1].reaction_n.x(), 40.0 * 0.02 / 0.5, 1e-8);
}

TEST(Handle, RemembersTheLargestForceAndItsTime) {
  Scene scene = drawn_out(0.0);
  scene.handles[1].velocity_m_per_s.reset();
  scene.handles[1].motion = {{0.4, {0.02, 0.0, 0.0}, Vec3::Zero()}, {1.0, Vec3::Zero(), Vec3::Zero()}};
  const RunSummary summary = measured(scene);
  EXPECT_NEAR(summary.handles[1].max_reaction_n, 40.0 * 0.02 / 0.5, 1e-8);
  EXPECT_NEAR(summary.handles[1].max_reaction_t_s, 0.4, 1e-9);
  EXPECT_LT(summary.handles[1].reaction_n.norm(), 1e-8);
}

// Each node goes to the first handle that selects it; guides are no handles.
TEST(Handle, WithoutANodeOfItsOwnCarriesNothing) {
  Scene scene = drawn_out(0.02);
  scene.handles.push_back(pin(0, -1));
  scene.guides = {{0, 2}};
  const RunSummary summary = measured(scene);
  ASSERT_EQ(summary.handles.size(), 3U);
  EXPECT_EQ(summary.handles[2].reaction_n, Vec3(Vec3::Zero()));
  EXPECT_GT(summary.handles[1].reaction_n.x(), 1.0);
}

TEST(Handle, NoStepMeasuresNoForceAndNoHandleNone) {
  Scene scene = drawn_out(0.02);
  scene.duration_s = 0.0;
  EXPECT_TRUE(std::isnan(measured(scene).handles.at(1).reaction_n.x()));
  EXPECT_TRUE(std::isnan(measured(scene).handles.at(1).max_reaction_n));
  scene.handles.clear();
  EXPECT_TRUE(measured(scene).handles.empty());
}

}  // namespace
}  // namespace slipstitch::testing
