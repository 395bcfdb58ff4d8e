// SPDX-License-Identifier: MIT
// Which stencils a pool builds, and with which constants.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "force/bending_jamming.h"
#include "force/yarn_forces.h"
#include "sample_models.h"

namespace slipstitch::testing {
namespace {

TEST(Pools, CoverEverySegmentBendAndDiagonalOnce) {
  const Model model = everything_on();  // two yarns of six visits, two contacts with all outer nodes
  EXPECT_EQ(Stretch(model).size(), 10);
  EXPECT_EQ(Gravity(model).size(), 10);
  EXPECT_EQ(Bending(model).size(), 8);
  EXPECT_EQ(BendingJamming(model).size(), 8);
  EXPECT_EQ(Wrapping(model).size(), 4);
  EXPECT_EQ(ContactLength(model).size(), 4);
  EXPECT_EQ(ParallelContact(model).size(), 2);  // free segments with a contact at one end or both, but no tails
}

TEST(Pools, LeaveOutWhatAnotherCopyOfThePeriodOwns) {
  Model model = everything_on();
  model.topology.visit_owned.assign(12, 1);
  for (std::size_t i = 6; i < 12; ++i) model.topology.visit_owned[i] = 0;  // yarn B
  model.topology.contacts[1].owned = false;
  EXPECT_EQ(Stretch(model).size(), 5);
  EXPECT_EQ(Gravity(model).size(), 5);
  EXPECT_EQ(Bending(model).size(), 4);
  EXPECT_EQ(BendingJamming(model).size(), 4);
  EXPECT_EQ(Wrapping(model).size(), 2);
  EXPECT_EQ(ContactLength(model).size(), 2);
  EXPECT_EQ(ParallelContact(model).size(), 1);
}

TEST(Pools, LeaveOutTheDiagonalThatLacksAnOuterNode) {
  Model model = everything_on();
  model.topology.contacts[0].q5 = -1;
  const Wrapping wrapping(model);
  ASSERT_EQ(wrapping.size(), 3);
  EXPECT_EQ(wrapping.coords(0)[0], 3 * model.topology.contacts[0].q0);
  EXPECT_EQ(wrapping.contact(1), 1);
}

TEST(Pools, OfTouchesShareTheBodiesAndThePointsThatTouchThem) {
  const YarnForces forces = make_forces(everything_on());
  const SharedTouchParts& parts = std::get<ColliderContact>(forces).parts();
  EXPECT_EQ(parts->bodies.size(), 3u);
  EXPECT_EQ(std::get<ColliderFriction>(forces).parts(), parts);
  EXPECT_EQ(std::get<BodyContact>(forces).parts(), parts);
  EXPECT_EQ(std::get<BodyFriction>(forces).parts(), parts);
}

TEST(Pools, WrapBothDiagonalsWithTheSignOfTheStitch) {
  const Model model = everything_on();
  const Wrapping wrapping(model);
  const auto nodes = [&](int k) {
    const auto c = wrapping.coords(k);
    return std::array{c[0] / 3, c[3] / 3, c[6] / 3, c[9] / 3};
  };
  EXPECT_EQ(nodes(0), (std::array{1, 2, 4, 0}));  // q0 q1 q3 q4
  EXPECT_EQ(nodes(1), (std::array{2, 1, 6, 3}));  // q1 q0 q2 q5
  EXPECT_EQ(wrapping.wrap(0).rest, kPi / 2);
  EXPECT_EQ(wrapping.wrap(1).rest, kPi / 2);
  EXPECT_EQ(wrapping.wrap(2).rest, -kPi / 2);
}

// V of the first stencil at the start, by the definition.
TEST(Pools, WrapStiffnessIsAlphaEIOverSquaredRestLengthUnlessGiven) {
  Model model = everything_on();
  const double L = rest_length(model.topology, 1);
  const auto energy = [&] {
    const Wrapping wrapping(model, WrapFadeForm::plain);
    Vec<12> q;
    for (int i = 0; i < 12; ++i) q[i] = model.start_q[wrapping.coords(0)[static_cast<std::size_t>(i)]];
    const double psi = wrap_angle(q.segment<3>(0), q.segment<3>(3), q.segment<3>(6), q.segment<3>(9));
    const double fade = wrap_fade(q, L);
    return wrapping.eval(0, q, nullptr, nullptr) / (0.5 * std::pow(wrap_excess(psi, kPi / 2), 2) * fade);
  };
  model.effects.wrapping->alpha = 0.4;
  EXPECT_NEAR(energy() / (0.4 * model.yarn.bending_nm2 / L), 1.0, 1e-12);
  model.effects.wrapping->stiffness_n = 0.02;
  EXPECT_NEAR(energy() / (0.02 * L), 1.0, 1e-12);
}

TEST(Pools, NeighbouringContactsKeepApartByTheirDiameterOrShareOfTheRestLength) {
  Model model = everything_on();
  const double rest = rest_length(model.topology, ParallelContact(model).coords(0)[0] - model.topology.arc_coord(0));
  const double k_c = model.yarn.stretch_n / std::pow(2 * model.yarn.radius_m, 2);
  const auto energy = [&](double gap) { return ParallelContact(model).eval(0, Vec<2>(0.0, gap), nullptr, nullptr); };
  for (double radius : {0.2e-3, 5e-3}) {  // diameter below and above 0.7 rest
    model.effects.parallel_contact->stiffness_n_per_m2 = k_c;
    model.yarn.radius_m = radius;
    const double d = std::min(2 * radius, 0.7 * rest);
    EXPECT_EQ(energy(d * 1.001), 0.0);
    EXPECT_NEAR(energy(0.5 * d) / (0.5 * k_c * rest * 0.25 * d * d), 1.0, 1e-12);
  }
}

TEST(Pools, JammingMultipliesTheBendingEnergyByItsFactor) {
  const double k_b = 4.5e-8, W = 2e-3, kappa_j = kPi / W;
  const JammingParameters p{k_b, std::log(1000.0), 2.0};
  const auto bend = [&](double theta) {
    Vec<11> q;
    q << -1e-3, 0, 0, 0.0, 0, 0, 0, 1e-3 * std::cos(theta), 1e-3 * std::sin(theta), 0, W;
    return q;
  };
  const auto factor = [&](double theta) {
    const Vec<11> q = bend(theta);
    return 1.0 + bending_jamming_energy(p, kappa_j, q, nullptr, nullptr) / bending_energy(k_b, q, nullptr, nullptr);
  };
  EXPECT_EQ(factor(1.5), 1.0);
  EXPECT_NEAR(factor(0.75 * kPi), std::sqrt(1000.0), 1e-9);  // half way between pi/2 and pi
  EXPECT_NEAR(factor(0.9999 * kPi), 1000.0, 1e-3);
  Vec<11> crowded = bend(1.5);
  crowded[10] = 0.25 * W;  // arcs slide together: four times the curvature
  EXPECT_NEAR(
      bending_jamming_energy(p, kappa_j, crowded, nullptr, nullptr) / bending_energy(k_b, crowded, nullptr, nullptr),
      999.0, 1e-9);
}

TEST(Pools, AnEnergyThatWouldPassThroughZeroArcLengthIsInfinite) {
  Vec<8> segment;
  segment << 0, 0, 0, 1e-3, 1e-3, 0, 0, 1e-3;
  EXPECT_EQ(stretch_energy(1.0, segment, nullptr, nullptr), std::numeric_limits<double>::infinity());
  Vec<11> bend;
  bend << 0, 0, 0, 1e-3, 1e-3, 0, 0, 1e-3, 1e-3, 0, 1e-4;
  EXPECT_EQ(bending_energy(1.0, bend, nullptr, nullptr), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace slipstitch::testing
