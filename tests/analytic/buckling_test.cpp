// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kStretch = 1e9;  // EI = L = 1
constexpr double kGhost = 1e-7;   // as in the cantilever tests

enum class Support { pinned, clamped_free };

/// A straight column of arc length 1 under the load P along -x, uniformly compressed by it: an equilibrium.
Model column(Support support, int pieces, double load) {
  Scene scene;
  BareYarn yarn = straight_yarn(Vec3::Zero(), (1.0 - load / kStretch) * Vec3::UnitX(), pieces);
  for (int i = 0; i <= pieces; ++i) yarn.arc_lengths_m.push_back(static_cast<double>(i) / pieces);
  if (support == Support::clamped_free) {
    yarn.points.insert(yarn.points.begin(), Vec3(-kGhost, 0.0, 0.0));
    yarn.arc_lengths_m.insert(yarn.arc_lengths_m.begin(), -kGhost);
    scene.handles = {pin(0, 0), pin(0, 1)};
    scene.loads = {{YarnPoint{0, -1}, {-load, 0.0, 0.0}}};
  } else {
    scene.handles = {pin(0, 0), pin(0, -1)};
  }
  scene.yarns = {yarn};
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1.0, .stretch_n = kStretch, .bending_nm2 = 1.0};
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  return checked_model(scene);
}

bool stable(Support support, int pieces, double load) {
  const Model model = column(support, pieces, load);
  const YarnForces forces = make_forces(model);
  const DofMap map = make_dof_map(model);
  Assembly assembly(forces, map);
  VecX gradient;
  SparseMatrix hessian;
  assembly.derivatives(forces, model.start_q, HessianMode::exact, gradient, hessian);
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-4);  // round-off of k_s
  return make_cholmod_solver()->factor(hessian) == LinearStatus::ok;
}

/// Load at which the lowest eigenvalue of the Hessian passes zero.
double buckling_load(Support support, int pieces) {
  double below = 0.1, above = 20.0;
  EXPECT_TRUE(stable(support, pieces, below));
  EXPECT_FALSE(stable(support, pieces, above));
  for (int i = 0; i < 40; ++i) {
    const double load = 0.5 * (below + above);
    (stable(support, pieces, load) ? below : above) = load;
  }
  return below;
}

TEST(Buckling, PinnedChainBucklesAtItsExactLoad) {
  double before = 0.0;
  for (const int n : {4, 8, 16, 32, 64}) {
    const double s = std::sin(kPi / (2.0 * n)), load = buckling_load(Support::pinned, n);
    EXPECT_NEAR(load / (4.0 * n * n * s * s), 1.0, 1e-6) << n;
    const double error = load - kPi * kPi;
    if (before != 0.0) {
      EXPECT_NEAR(order(before, error), 2.0, 0.05) << n;
    }
    before = error;
  }
}

TEST(Buckling, ClampedFreeColumnApproachesEulersLoad) {
  const double exact = kPi * kPi / 4.0;
  EXPECT_NEAR(buckling_load(Support::clamped_free, 16) / exact - 1.0, -8.0e-4, 0.1e-4);
  EXPECT_NEAR(buckling_load(Support::clamped_free, 64) / exact - 1.0, -5.0e-5, 0.1e-5);
}

}  // namespace
}  // namespace slipstitch::testing
