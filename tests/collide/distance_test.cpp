// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "collide/rigid_body.h"
#include "support/collider_shapes.h"

namespace slipstitch {
namespace {

constexpr double kSize = 0.1;

std::vector<std::pair<std::string, Shape>> shapes() {
  return {{"plane", Plane{{0.01, 0.02, 0.0}, {0.3, 1.0, -0.2}}},
          {"sphere", Sphere{{0.02, 0.0, 0.01}, kSize}},
          {"capsule", Capsule{{-kSize, 0.0, 0.0}, {kSize, 0.05, 0.02}, 0.04}},
          {"box", Box{{0.01, 0.0, 0.0}, {0.05, 0.08, 0.03}, {0.2, -0.4, 0.9}}},
          {"mesh", test::box_mesh({0.0, 0.01, 0.0}, {0.05, 0.08, 0.03})}};
}

/// A tumbling flight, so that bodies are checked away from where they start.
std::vector<Keyframe> tumbling() { return {{0.0}, {1.0, {0.3, -0.2, 0.1}, {0.5, 1.0, -0.7}}}; }

Vec3 random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-2.5 * kSize, 2.5 * kSize);
  return {uniform(random), uniform(random), uniform(random)};
}

TEST(Distance, HasItsNormalForGradientAndItsCurvatureForHessian) {
  std::mt19937_64 random(3);
  constexpr double step = 1e-5;
  for (const auto& [name, shape] : shapes()) {
    RigidBody body({shape, 0.0, tumbling()});
    body.move_to(0.4);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = body.to_space(random_point(random));
      const Distance d = body.distance(p);
      if (d.phi < 1e-3) continue;  // inside, and in the creases inside, nothing is asked
      bool crease = false;
      Vec3 gradient;
      Mat3 hessian;
      for (int c = 0; c < 3; ++c) {
        const Vec3 off = step * Vec3::Unit(c);
        const Distance plus = body.distance(p + off), minus = body.distance(p - off);
        crease = crease || (plus.curvature - minus.curvature).norm() > 1e-2 * (1.0 + d.curvature.norm());
        gradient[c] = (plus.phi - minus.phi) / (2.0 * step);
        hessian.col(c) = (plus.normal - minus.normal) / (2.0 * step);
      }
      if (crease) continue;  // between a face and an edge the curvature jumps
      EXPECT_LT((gradient - d.normal).norm(), 1e-6) << name << " at " << p.transpose();
      EXPECT_LT((hessian - d.curvature).norm(), 1e-5 * (1.0 + d.curvature.norm())) << name << " at " << p.transpose();
    }
  }
}

TEST(Distance, IsThatOfTheSurface) {
  std::mt19937_64 random(5);
  for (const auto& [name, shape] : shapes()) {
    const RigidBody body({shape, 0.0, {}});
    int outside = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = random_point(random);
      const Distance d = body.distance(p);
      if (!(d.phi > 0.0)) continue;
      ++outside;
      EXPECT_NEAR(body.distance(p - d.phi * d.normal).phi, 0.0, 1e-12) << name;  // the foot lies on it
      EXPECT_NEAR(body.distance(p - 0.5 * d.phi * d.normal).phi, 0.5 * d.phi, 1e-12) << name;
      EXPECT_LT(body.distance(p - (d.phi + 1e-6) * d.normal).phi, 0.0) << name;
    }
    EXPECT_GT(outside, 50) << name;
  }
}

TEST(Distance, OfABoxIsThatOfItsMesh) {
  std::mt19937_64 random(7);
  const Vec3 half(0.05, 0.08, 0.03);
  const RigidBody box({Box{Vec3::Zero(), half, Vec3::Zero()}, 0.0, {}}),
      mesh({test::box_mesh(Vec3::Zero(), half), 0.0, {}});
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random_point(random);
    const Distance a = box.distance(p), b = mesh.distance(p);
    EXPECT_NEAR(a.phi, b.phi, 1e-14) << p.transpose();
    if (a.phi > 0.0) {
      EXPECT_LT((a.normal - b.normal).norm(), 1e-9);
      EXPECT_LT((a.curvature - b.curvature).norm(), 1e-6 * (1.0 + a.curvature.norm()));
    }
  }
}

TEST(RigidBody, CarriesItsPointsAlong) {
  RigidBody body({Sphere{{0.1, 0.0, 0.0}, kSize}, 0.0, {{0.0}, {2.0, {0.0, 1.0, 0.0}, {0.0, kPi, 0.0}}}});
  body.move_to(1.0);
  EXPECT_LT((body.to_space({0.2, 0.0, 0.0}) - Vec3(0.1, 0.5, -0.1)).norm(), 1e-15);  // a quarter turn about its centre
  const Vec3 p(0.3, 0.1, -0.2);
  EXPECT_LT((body.to_body(body.to_space(p)) - p).norm(), 1e-15);
  EXPECT_NEAR(body.distance({0.1, 0.5, 0.3}).phi, 0.2, 1e-15);
}

}  // namespace
}  // namespace slipstitch
