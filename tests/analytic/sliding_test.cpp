// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>

#include "analytic_helpers.h"

namespace slipstitch::testing {
namespace {

constexpr int kPieces = 6;
constexpr int kCross[] = {2, 3};  // point of each yarn in the crossing
constexpr double kPiece = 0.05;

/// Two crossed yarns thrown with a spin. Every point starts on its straight line without any force, so nothing jumps;
/// then the first yarn, which is not crossed at its middle, is flung out through the contact.
Scene thrown_crossing() {
  constexpr double kSpin = 20.0;
  const Vec3 flight(0.5, 0.3, 0.2), centre(-0.025, 0.0, 0.0), spin(0.0, 0.3 * kSpin, kSpin);
  Scene scene;
  scene.yarns = {straight_yarn(Vec3(-0.15, 0.0, 0.0), {0.15, 0.0, 0.0}, kPieces),
                 straight_yarn(Vec3(-0.05, -0.15, 0.0), {-0.05, 0.15, 0.0}, kPieces)};
  scene.crossings = {{0, kCross[0], 1, kCross[1]}};
  for (int y = 0; y < 2; ++y) {
    for (int i = 0; i <= kPieces; ++i) {
      const Vec3 x = scene.yarns[static_cast<std::size_t>(y)].points[static_cast<std::size_t>(i)];
      scene.initial_velocities.push_back({YarnPoint{y, i}, flight + spin.cross(x - centre)});
    }
  }
  scene.yarn = {.radius_m = 1e-3, .linear_density_kg_per_m = 1e-2, .stretch_n = 5.0, .bending_nm2 = 1e-5};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.sliding.emplace();
  return scene;
}

Vec3 linear_momentum(const Simulation& sim) {
  Vec3 sum = Vec3::Zero();
  for (int n = 0; n < sim.model().topology.num_nodes; ++n) sum += sim.state().p.segment<3>(3 * n);
  return sum;
}

Vec3 angular_momentum(const Simulation& sim) {
  Vec3 sum = Vec3::Zero();
  for (int n = 0; n < sim.model().topology.num_nodes; ++n)
    sum += Vec3(sim.state().q.segment<3>(3 * n)).cross(Vec3(sim.state().p.segment<3>(3 * n)));
  return sum;
}

double total_energy(Simulation& sim) {
  const auto terms = sim.energies();
  return std::accumulate(terms.begin(), terms.end(), 0.0, [](double sum, const auto& e) { return sum + e.second; });
}

/// How far the first yarn has slid through the contact [m].
double slid(const Simulation& sim) { return std::abs(arc(sim, 0, kCross[0]) - kCross[0] * kPiece); }

TEST(FreeFlight, LinearMomentumIsExactWhileYarnsSlide) {
  Simulation sim(checked_model(thrown_crossing()));
  const Vec3 start = linear_momentum(sim);
  double farthest = 0.0;
  for (int n = 0; n < 40; ++n) {
    advance(sim, 1e-3, tight(1e-10, 0.0));
    ASSERT_FALSE(HasFatalFailure());
    ASSERT_LT((linear_momentum(sim) - start).norm(), 1e-12 * start.norm()) << n;
    farthest = std::max(farthest, slid(sim));
  }
  EXPECT_GT(farthest, 0.2 * kPiece);
}

struct Drift {
  Vec3 angular;
  double energy, slid;
};

Drift drift(double h, double end) {
  Simulation sim(checked_model(thrown_crossing()));
  const Vec3 angular = angular_momentum(sim);
  const double energy = total_energy(sim);
  double farthest = 0.0;
  for (int n = 0; n < std::lround(end / h); ++n) {
    advance(sim, h, tight(1e-10, 0.0));
    if (::testing::Test::HasFatalFailure()) break;
    farthest = std::max(farthest, slid(sim));
  }
  return {angular_momentum(sim) - angular, total_energy(sim) - energy, farthest};
}

TEST(FreeFlight, AngularMomentumAndEnergyDriftWithOrderOne) {
  constexpr double kStep = 4e-4, kEnd = 0.04;
  const Drift coarse = drift(kStep, kEnd), middle = drift(kStep / 2, kEnd), fine = drift(kStep / 4, kEnd),
              finest = drift(kStep / 8, kEnd);
  EXPECT_GT(finest.slid, 0.2 * kPiece);
  EXPECT_NEAR(order(coarse.angular.norm(), middle.angular.norm()), 1.0, 0.15);
  EXPECT_NEAR(order(middle.angular.norm(), fine.angular.norm()), 1.0, 0.1);
  EXPECT_NEAR(order(fine.angular.norm(), finest.angular.norm()), 1.0, 0.05);
  EXPECT_NEAR(order(coarse.energy, middle.energy), 1.0, 0.15);
  EXPECT_NEAR(order(middle.energy, fine.energy), 1.0, 0.1);
  EXPECT_NEAR(order(fine.energy, finest.energy), 1.0, 0.05);
  EXPECT_LT(fine.energy, 0.0);  // implicit Euler loses energy
}

constexpr int kContacts = 10;
constexpr double kSpacing = 0.01, kTail = 0.03, kPull = 5e-3, kNormal = 0.02;

/// A yarn lying across ten others that are held at their ends, drawn out by 5 mm against friction.
Scene row_of_contacts() {
  Scene scene;
  BareYarn yarn;
  yarn.points = {Vec3(-kTail, 0.0, 0.0)};
  for (int k = 0; k < kContacts; ++k) yarn.points.push_back({k * kSpacing, 0.0, 0.0});
  yarn.points.push_back({(kContacts - 1) * kSpacing + kTail, 0.0, 0.0});
  scene.yarns = {yarn};
  for (int k = 0; k < kContacts; ++k) {
    const double x = k * kSpacing;
    scene.yarns.push_back(straight_yarn(Vec3(x, -0.02, 0.0), {x, 0.02, 0.0}, 2));
    scene.yarns.back().prestretch = 1.01;
    scene.crossings.push_back({0, k + 1, k + 1, 1});
    scene.handles.push_back(pin(k + 1, 0));
    scene.handles.push_back(pin(k + 1, -1));
  }
  scene.handles.push_back({YarnPoint{0, -1}, {{1.0, Vec3(kPull, 0.0, 0.0), Vec3::Zero()}}, false});
  scene.loads = {{YarnPoint{0, 0}, {-0.05, 0.0, 0.0}}};  // keeps the free tail straight
  scene.effects.stretch.emplace();
  scene.effects.sliding.emplace();
  scene.effects.sliding_friction = SlidingFrictionEffect{0.5, 1000.0, kNormal};
  return scene;
}

/// Where the material at arc length `u` of yarn 0 lies.
Vec3 marker(const Simulation& sim, double u) {
  int i = 0;
  while (i < kContacts && arc(sim, 0, i + 1) < u) ++i;
  const double share = (u - arc(sim, 0, i)) / (arc(sim, 0, i + 1) - arc(sim, 0, i));
  return position(sim, 0, i) + share * (position(sim, 0, i + 1) - position(sim, 0, i));
}

/// How much longer than at rest the yarn is from arc length `u` to its drawn end [m].
double elongation(const Simulation& sim, double u) {
  double sum = 0.0;
  for (int i = 0; i <= kContacts; ++i) {
    const double from = std::max(u, arc(sim, 0, i)), to = arc(sim, 0, i + 1);
    if (to > from) sum += tension(sim, 0, i) / sim.model().yarn.stretch_n * (to - from);
  }
  return sum;
}

TEST(PullThrough, MaterialFollowsTheHandLessItsStretch) {
  Simulation sim(checked_model(row_of_contacts()));
  std::vector<double> start_arc;
  for (int i = 0; i <= kContacts + 1; ++i) start_arc.push_back(arc(sim, 0, i));
  const std::vector<double> marked = {0.01, kTail + 2.0 * kSpacing, kTail + 4.4 * kSpacing, kTail + 8.9 * kSpacing};
  std::vector<Vec3> from;
  std::vector<double> stretched;
  for (const double u : marked) {
    from.push_back(marker(sim, u));
    stretched.push_back(elongation(sim, u));
  }
  advance(sim, 100, 0.01, tight(1e-9, 1e-9));
  for (std::size_t m = 0; m < marked.size(); ++m) {
    const double moved = marker(sim, marked[m]).x() - from[m].x(), stretch = elongation(sim, marked[m]) - stretched[m];
    EXPECT_GT(stretch, 1e-6);
    EXPECT_LT(stretch, 4e-4);
    EXPECT_NEAR(moved, kPull - stretch, 1e-10) << marked[m];
  }
  // Ten contacts brake with mu F_n each, so the hand pulls with the tail's load and all of them.
  EXPECT_NEAR(tension(sim, 0, kContacts), 0.05 + kContacts * 0.5 * kNormal, 1e-3 * 0.15);
}

TEST(PullThrough, YarnPassingAContactIsWhatItsSidesGainAndLose) {
  Simulation sim(checked_model(row_of_contacts()));
  std::vector<double> start_arc;
  for (int i = 0; i <= kContacts + 1; ++i) start_arc.push_back(arc(sim, 0, i));
  advance(sim, 100, 0.01, tight(1e-9, 1e-9));
  const auto length = [&](int first, int last) {
    double sum = 0.0;
    for (int i = first; i < last; ++i) sum += arc(sim, 0, i + 1) - arc(sim, 0, i);
    return sum;
  };
  const double whole = start_arc.back() - start_arc.front();
  EXPECT_NEAR(length(0, kContacts + 1), whole, 1e-15);
  for (int k = 1; k <= kContacts; ++k) {
    const auto i = static_cast<std::size_t>(k);
    // The material that was in the contact, seen in space: so much yarn lies between it and the contact now.
    const Vec3 gone = marker(sim, start_arc[i]) - position(sim, 0, k);
    ASSERT_GT(gone.x(), 0.8 * kPull) << k;
    double passed = 0.0, left = gone.norm();
    for (int s = k; left > 0.0 && s <= kContacts; ++s) {
      const double piece = (position(sim, 0, s + 1) - position(sim, 0, s)).norm(), here = std::min(piece, left);
      passed += here / (1.0 + tension(sim, 0, s) / sim.model().yarn.stretch_n);
      left -= here;
    }
    EXPECT_NEAR(passed, (start_arc[i] - start_arc.front()) - length(0, k), 1e-12) << k;
    EXPECT_NEAR(passed, length(k, kContacts + 1) - (start_arc.back() - start_arc[i]), 1e-12) << k;
  }
}

}  // namespace
}  // namespace slipstitch::testing
