// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "math/types.h"

namespace slipstitch::testing {

inline constexpr int kNumHinges = 200;

/// Hinges x0, x1, x3, x4 of millimetre size with any wrap angle, both heights at least a third of the axis.
inline std::vector<Vec<12>> random_hinges() {
  std::mt19937_64 random(99);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.3, 1.0), turn(-3.14, 3.14);
  std::vector<Vec<12>> hinges;
  for (int i = 0; i < kNumHinges; ++i) {
    const Vec3 e = Vec3::UnitX() * 1e-3, up = Vec3::UnitY() * 1e-3, side = Vec3::UnitZ() * 1e-3;
    const double psi = turn(random);
    Vec<12> q;
    q << Vec3::Zero(), e, uniform(random) * e + uniform(random) * (-std::cos(psi) * up - std::sin(psi) * side),
        uniform(random) * e + uniform(random) * up;
    const Eigen::Quaterniond spin =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    const Vec3 shift(1e-3 * normal(random), 1e-3 * normal(random), 1e-3 * normal(random));
    for (int n = 0; n < 4; ++n) q.segment<3>(3 * n) = spin * Vec3(q.segment<3>(3 * n)) + shift;
    hinges.push_back(q);
  }
  return hinges;
}

inline Vec3 node(const Vec<12>& q, int slot) { return q.segment<3>(3 * slot); }

template <class Move>
Vec<12> each_node(const Vec<12>& q, Move&& move) {
  Vec<12> r;
  for (int n = 0; n < 4; ++n) r.segment<3>(3 * n) = move(node(q, n));
  return r;
}

}  // namespace slipstitch::testing
