// SPDX-License-Identifier: MIT
#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr double kGravity = 9.81;

/// A yarn over N guides that turn it by phi in all, drawn at one end against a weight of 1 N at the other.
/// Ratio of the tensions once every contact slides.
double capstan_ratio(double mu, double phi, int guides) {
  constexpr double kPiece = 0.1, kTail = 2.0, kPull = 0.01, kSlackTension = 1.0;
  constexpr int kSteps = 100;
  const double turn = phi / guides;
  const auto heading = [&](int piece) { return Vec3(std::cos(turn * piece), std::sin(turn * piece), 0.0); };
  Scene scene;
  BareYarn yarn;
  yarn.points = {Vec3::Zero(), kTail * heading(0)};
  for (int i = 1; i < guides; ++i) yarn.points.push_back(yarn.points.back() + kPiece * heading(i));
  yarn.points.push_back(yarn.points.back() + kTail * heading(guides));
  scene.yarns = {yarn};
  scene.yarn.stretch_n = 1e5;
  for (int i = 1; i <= guides; ++i) scene.guides.push_back({0, i});
  scene.effects.stretch.emplace();
  scene.effects.sliding.emplace();
  scene.effects.sliding_friction = SlidingFrictionEffect{mu, 1e5, std::nullopt};
  scene.loads = {{YarnPoint{0, 0}, -kSlackTension * heading(0)}};
  scene.handles = {{YarnPoint{0, -1}, {{1.0, kPull * heading(guides), Vec3::Zero()}}, false}};
  Simulation sim(checked_model(scene));
  advance(sim, kSteps, 1.0 / kSteps, tight(1e-9, 1e-8));
  for (int i = 1; i <= guides; ++i)
    EXPECT_LT(arc(sim, 0, i), kTail + (i - 1) * kPiece - 0.5 * kPull) << "does not slide";
  return tension(sim, 0, guides) / tension(sim, 0, 0);
}

// N contacts of which each turns d = phi/N and feels both tensions: ((1 + mu sin(d/2))/(1 - mu sin(d/2)))^N.
TEST(Capstan, TensionRatioIsTheDiscreteFormula) {
  constexpr double kMu = 0.3;
  const double exact = std::exp(kMu * kPi);
  double before = 0.0;
  for (const int guides : {4, 8, 16, 32}) {
    const double ratio = capstan_ratio(kMu, kPi, guides), s = kMu * std::sin(kPi / (2.0 * guides));
    EXPECT_NEAR(ratio / std::pow((1.0 + s) / (1.0 - s), guides), 1.0, 1e-3) << guides;
    const double error = ratio / exact - 1.0;
    if (before != 0.0) {
      EXPECT_NEAR(order(before, error), 2.0, 0.1) << guides;
    }
    before = error;
  }
}

TEST(Capstan, RatioFollowsFrictionAndAngle) {
  for (const auto& [mu, phi] : {std::pair(0.1, kPi), std::pair(0.3, 2.0 * kPi), std::pair(0.5, kPi / 2.0)}) {
    const double s = mu * std::sin(phi / 24.0);
    EXPECT_NEAR(capstan_ratio(mu, phi, 12) / std::pow((1.0 + s) / (1.0 - s), 12), 1.0, 1e-3) << mu << " " << phi;
  }
}

/// A straight yarn through one guide, mostly behind it: a block that slides along its own line.
struct Block {
  static constexpr double kMass = 0.02, kLength = 2.0, kStick = 1e7;

  static Scene scene(double pull, double mu, double normal, double speed) {
    Scene scene;
    BareYarn yarn;
    yarn.points = {Vec3(-0.2, 0.0, 0.0), Vec3::Zero(), Vec3(kLength - 0.2, 0.0, 0.0)};
    yarn.velocity_m_per_s = {-speed, 0.0, 0.0};
    scene.yarns = {yarn};
    scene.yarn.linear_density_kg_per_m = kMass / kLength;
    scene.yarn.stretch_n = 1e8;
    scene.guides = {{0, 1}};
    scene.effects.inertia.emplace();
    if (pull > 0.0) scene.effects.gravity.emplace().acceleration_m_per_s2 = {pull, 0.0, 0.0};
    scene.effects.stretch.emplace();
    scene.effects.sliding.emplace();
    scene.effects.sliding_friction = SlidingFrictionEffect{mu, kStick, normal};
    return scene;
  }
};

// Incline of 30 degrees: pull m g sin 30, F_n = m g cos 30. The anchored spring gives way by mu F_n/k_f.
TEST(Incline, SlidesWithItsAccelerationAboveTheFrictionAngle) {
  constexpr double kMu = 0.5, kStep = 1e-3, kEnd = 0.5, kAcceleration = 0.657145394437;
  const double normal = Block::kMass * kGravity * std::cos(kPi / 6.0);
  Simulation sim(checked_model(Block::scene(0.5 * kGravity, kMu, normal, 0.0)));
  advance(sim, 500, kStep, tight(1e-8, 0.0));
  const double slid = -arc(sim, 0, 1) + 0.2, exact = 0.5 * kAcceleration * kEnd * kEnd;
  EXPECT_NEAR(slid, exact, kMu * normal / Block::kStick + 0.5 * kStep * kAcceleration * kEnd);
  const double v = -sim.state().v[sim.model().topology.arc_coord(1)];
  EXPECT_NEAR(v / (kAcceleration * kEnd), 1.0, 2e-3);
}

TEST(Incline, SticksBelowTheFrictionAngle) {
  constexpr double kMu = 0.6;
  const double normal = Block::kMass * kGravity * std::cos(kPi / 6.0);
  Simulation sim(checked_model(Block::scene(0.5 * kGravity, kMu, normal, 0.0)));
  advance(sim, 500, 1e-3, tight(1e-8, 0.0));
  const double give = Block::kMass * 0.5 * kGravity / Block::kStick;  // F_t/k_f and no further
  EXPECT_NEAR(0.2 - arc(sim, 0, 1), give, 1e-2 * give);
}

// v0^2/(2 mu g), shifted by no more than mu F_n/k_f + v0 h/2.
TEST(Stopping, DistanceIsThatOfABlock) {
  constexpr double kMu = 0.4, kSpeed = 1.5, kStep = 1e-3;
  const double normal = Block::kMass * kGravity;
  Simulation sim(checked_model(Block::scene(0.0, kMu, normal, kSpeed)));
  const int stopping = static_cast<int>(std::ceil(kSpeed / (kMu * kGravity * kStep)));
  const auto speed = [&] { return std::abs(sim.state().v[sim.model().topology.arc_coord(1)]); };
  advance(sim, stopping - 10, kStep, tight(1e-8, 0.0));
  EXPECT_GT(speed(), 5.0 * kMu * kGravity * kStep);
  advance(sim, 210, kStep, tight(1e-8, 0.0));
  const double exact = kSpeed * kSpeed / (2.0 * kMu * kGravity);
  EXPECT_NEAR(std::abs(arc(sim, 0, 1) - 0.2), exact, kMu * normal / Block::kStick + 0.5 * kSpeed * kStep);
  EXPECT_LT(speed(), 1e-3);
}

}  // namespace
}  // namespace slipstitch::testing
