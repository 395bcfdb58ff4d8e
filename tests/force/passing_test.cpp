// SPDX-License-Identifier: MIT
// What tells that points of yarn no longer keep it from passing: segments that have outgrown their points, and ways on
// which points go through each other.
#include <gtest/gtest.h>

#include "force/self_collision.h"
#include "force/touch_samples.h"
#include "model/model.h"

namespace slipstitch {
namespace {

constexpr double kRadius = 1e-3, kPiece = 1e-2;

/// Straight yarns of four pieces along x and, 4 radii above, along y.
Model two_yarns() {
  Scene scene;
  BareYarn along_x, along_y;
  for (int i = -2; i <= 2; ++i) {
    along_x.points.push_back({kPiece * (i + 0.5), 0, 0});
    along_y.points.push_back({0, kPiece * (i + 0.5), 4 * kRadius});
  }
  scene.yarns = {along_x, along_y};
  scene.yarn.radius_m = kRadius;
  scene.effects.stretch.emplace();
  scene.effects.self_collision.emplace();
  return compile(scene, nullptr);
}

State state_at(const VecX& q) {
  State state;
  state.q = q;
  state.v = VecX::Zero(q.size());
  return state;
}

/// The second yarn goes down.
VecX lowered(const Model& model, double by) {
  VecX q = model.start_q;
  for (int n = 5; n < 10; ++n) q[3 * n + 2] -= by;
  return q;
}

/// All grows along x about the middle.
VecX stretched(VecX q, double factor) {
  for (int n = 0; n < 10; ++n) q[3 * n] *= factor;
  return q;
}

TEST(Passing, SelfCollisionSeesPointsThatGoThroughEachOther) {
  const Model model = two_yarns();
  SelfCollision term(model);
  const State start = state_at(model.start_q);
  term.begin_step({1e-3, start});
  EXPECT_FALSE(term.passes(model.start_q, lowered(model, 2.9 * kRadius))) << "1.1 radii are left, more than half of 2";
  EXPECT_TRUE(term.passes(model.start_q, lowered(model, 3.1 * kRadius)));
  EXPECT_TRUE(term.passes(model.start_q, lowered(model, 8.0 * kRadius))) << "on the way, not at its end";
  VecX aside = model.start_q;
  for (int n = 5; n < 10; ++n) aside[3 * n] += 0.3;
  EXPECT_FALSE(term.passes(model.start_q, aside));
}

TEST(Passing, SelfCollisionSaysWhenYarnThatTouchesHasOutgrownItsPoints) {
  const Model model = two_yarns();
  SelfCollision term(model);
  const VecX touching = lowered(model, 2.1 * kRadius), above = lowered(model, 1.9 * kRadius);
  const State start = state_at(touching);
  term.begin_step({1e-3, start});
  EXPECT_FALSE(term.outgrown(touching));
  EXPECT_FALSE(term.outgrown(stretched(touching, 1.2)));
  EXPECT_TRUE(term.outgrown(stretched(touching, 2.0)));
  EXPECT_FALSE(term.outgrown(stretched(above, 2.0))) << "what touches nothing lets nothing through";
}

TEST(Passing, TouchSamplesSayWhenTheyAreTooFarApartNearSomething) {
  const Model model = two_yarns();
  const TouchSamples samples(model, kPiece, TouchPoints::all);
  const auto here = [](const Vec3&, double) { return true; };
  const auto nowhere = [](const Vec3&, double) { return false; };
  EXPECT_FALSE(samples.outgrown(model.start_q, here));
  EXPECT_FALSE(samples.outgrown(stretched(model.start_q, 1.45), here));
  EXPECT_TRUE(samples.outgrown(stretched(model.start_q, 1.55), here));
  EXPECT_FALSE(samples.outgrown(stretched(model.start_q, 1.55), nowhere));
  VecX slid = model.start_q;  // the yarn is as it was; more of it is on a segment
  slid[model.topology.arc_coord(0)] -= 0.6 * kPiece;
  EXPECT_TRUE(samples.outgrown(slid, here));
}

double energy(const SelfCollision& term, const VecX& q) {
  double sum = 0.0;
  for (int k = 0; k < term.size(); ++k) {
    Vec<12> x;
    for (std::size_t i = 0; i < 12; ++i) x[static_cast<Eigen::Index>(i)] = q[term.coords(k)[i]];
    sum += term.eval(k, x, nullptr, nullptr);
  }
  return sum;
}

// New points may be deeper in other yarn than the old ones let it, and may stay so for now.
TEST(Passing, AttemptsThatFailDoNotTightenWhatNewPointsMayKeep) {
  const Model model = two_yarns();
  const VecX touching = lowered(model, 2.08 * kRadius);
  bool tightened = false;
  for (double length = 1.25; length < 1.6; length += 0.06) {  // points come to lie nearer to each other, or farther
    SelfCollision term(model);
    State now = state_at(touching);
    const auto step_to = [&](double factor, double t) {
      now.q = stretched(touching, factor);
      now.t = t;
      term.begin_step({1e-3, now});
    };
    step_to(1.0, 0.0);
    step_to(length, 1e-3);
    step_to(1.3 * length, 2e-3);
    const double first = energy(term, now.q);
    for (int attempt = 0; attempt < 3; ++attempt) {
      step_to(1.3 * length, 2e-3);
      EXPECT_EQ(energy(term, now.q), first) << length;
    }
    step_to(1.3 * length, 3e-3);
    tightened = tightened || energy(term, now.q) > first;
  }
  EXPECT_TRUE(tightened);
}

TEST(Passing, TouchSamplesTightenOnceATimeAndNotToTheDeepest) {
  const Model model = two_yarns();
  constexpr double kDeepest = 1e-4;
  TouchSamples samples(model, kPiece, TouchPoints::all);
  VecX q = model.start_q;
  const auto overlap = [&](const Vec3& x) {  // the nodes are less deep than what comes between them
    for (int n = 0; n < 10; ++n)
      if (x == Vec3(q.segment<3>(3 * n))) return 0.2 * kDeepest;
    return kDeepest;
  };
  const auto slack = [&] {
    double most = 0.0;
    for (int i = 0; i < samples.size(); ++i) most = std::max(most, samples[i].slack);
    return most;
  };
  samples.follow(0.0, q, kDeepest, overlap);
  EXPECT_EQ(slack(), 0.0);
  q = stretched(q, 1.5);
  samples.follow(0.1, q, kDeepest, overlap);
  EXPECT_NEAR(slack(), 0.8 * kDeepest, 1e-12);
  samples.follow(0.1, q, kDeepest, overlap);
  EXPECT_NEAR(slack(), 0.8 * kDeepest, 1e-12);
  samples.follow(0.2, q, kDeepest, overlap);
  EXPECT_NEAR(slack(), 0.45 * kDeepest, 1e-12);
  for (int k = 3; k < 100; ++k) samples.follow(0.1 * k, q, kDeepest, overlap);
  EXPECT_NEAR(slack(), 0.1 * kDeepest, 1e-12);
}

}  // namespace
}  // namespace slipstitch
