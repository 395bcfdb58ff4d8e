// SPDX-License-Identifier: MIT
// How fast the error of every integrator falls with the step, where motion is smooth.
#include <array>
#include <cmath>
#include <cstdio>

#include "sim/simulation.h"
#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

constexpr double kEnd_s = 0.04;

VecX end_of(const Scene& scene, Integrator integrator, int steps) {
  FixedNumerics numerics;
  numerics.integrator = integrator;
  numerics.velocity_tolerance_m_per_s = 1e-9;
  Simulation sim(compile(scene, nullptr));
  for (int k = 0; k < steps; ++k) {
    const StepReport report = sim.step(kEnd_s / steps, numerics, {});
    EXPECT_TRUE(report.accepted) << to_string(report.newton.status) << " in step " << k;
    if (!report.accepted) break;
  }
  EXPECT_NEAR(sim.state().t, kEnd_s, 1e-12);
  return sim.state().q;
}

struct Method {
  const char* name;
  Integrator integrator;
  double order;
};

class Order : public ::testing::TestWithParam<Method> {};

TEST_P(Order, ErrorsFallWithThePowerOfTheStep) {
  const Scene scene = smooth_motion();
  const VecX exact = end_of(scene, Integrator::sdirk2, 8192);
  std::array<double, 4> error{};
  for (std::size_t k = 0; k < error.size(); ++k)
    error[k] = (end_of(scene, GetParam().integrator, 128 << k) - exact).cwiseAbs().maxCoeff();
  const double order = std::log2(error[2] / error[3]);
  std::printf("%s: errors %.2e %.2e %.2e %.2e m, order %.2f\n", GetParam().name, error[0], error[1], error[2], error[3],
              order);
  EXPECT_NEAR(order, GetParam().order, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Order,
                         ::testing::Values(Method{"implicit_euler", Integrator::implicit_euler, 1.0},
                                           Method{"bdf2", Integrator::bdf2, 2.0},
                                           Method{"sdirk2", Integrator::sdirk2, 2.0},
                                           Method{"implicit_midpoint", Integrator::implicit_midpoint, 2.0},
                                           Method{"linearised_euler", Integrator::linearised_euler, 1.0}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace slipstitch::testing
