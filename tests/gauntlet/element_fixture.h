// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "gauntlet/high_precision.h"
#include "support/trap_floating_point.h"

namespace slipstitch::testing {

/// A test of single elements: an invalid operation or a division by zero anywhere in it ends the program.
class Element : public ::testing::Test {
  TrapFloatingPoint trap_;
};

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// 1, 1e-1, ... 1e-9.
inline std::vector<double> decades(int last = -9) {
  std::vector<double> values;
  for (int e = 0; e >= last; --e) values.push_back(std::pow(10.0, e));
  return values;
}

template <int N>
struct Evaluated {
  double V = 0.0;
  Vec<N> g;
  Mat<N> hess;

  template <class Energy>
  Evaluated(const Energy& energy, const Vec<N>& q) {
    V = energy(q, &g, &hess);
  }
  bool finite() const { return std::isfinite(V) && g.allFinite() && hess.allFinite(); }
};

/// All three as they should be, each to a share `relative` of its size.
template <int N>
void expect_matches(const Evaluated<N>& e, const Reference& r, double relative) {
  EXPECT_LE(std::abs(e.V - r.V), relative * std::abs(r.V));
  EXPECT_LE((e.g - r.g).norm(), relative * r.g.norm());
  EXPECT_LE((e.hess - r.hess).norm(), relative * r.hess.norm());
}

}  // namespace slipstitch::testing
