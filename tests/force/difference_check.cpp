// SPDX-License-Identifier: MIT
#include "difference_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace slipstitch::testing {
namespace {

constexpr int kHalvings = 16;

void expect_order(const std::vector<double>& errors, double h0, int order, double noise, const char* what) {
  double line = 0.0;
  for (std::size_t k = 0; k < 4; ++k) line = std::max(line, std::ldexp(errors[k], order * static_cast<int>(k)));
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const int halvings = static_cast<int>(k);
    const double allowed = 2.0 * std::ldexp(line, -order * halvings) + noise / std::ldexp(h0, -halvings);
    ASSERT_LE(errors[k], allowed) << what << " after " << k << " halvings of " << h0;
  }
}

struct Differences {
  VecX g;
  MatX hess;
  double largest_V = 0.0, largest_g = 0.0, largest_hess = 0.0;
};

Differences central_differences(const VecX& q, double h, const Energy& energy) {
  const Eigen::Index n = q.size();
  Differences d{VecX(n), MatX(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    VecX up = q, down = q, g_up, g_down;
    MatX hess;
    up[i] += h;
    down[i] -= h;
    const double width = up[i] - down[i];
    const double V_up = energy(up, &g_up, &hess), V_down = energy(down, &g_down, nullptr);
    d.g[i] = (V_up - V_down) / width;
    d.hess.col(i) = (g_up - g_down) / width;
    d.largest_V = std::max({d.largest_V, std::abs(V_up), std::abs(V_down)});
    d.largest_g = std::max({d.largest_g, g_up.norm(), g_down.norm()});
    d.largest_hess = std::max(d.largest_hess, hess.norm());
  }
  return d;
}

}  // namespace

void expect_exact_derivatives(const VecX& q, double h0, int order, const Energy& energy) {
  VecX g;
  MatX hess;
  const double V = energy(q, &g, &hess);
  ASSERT_TRUE(std::isfinite(V) && g.allFinite() && hess.allFinite());
  std::vector<double> g_errors, hess_errors;
  double largest_V = std::abs(V), largest_g = g.norm(), largest_hess = hess.norm();
  for (int k = 0; k <= kHalvings; ++k) {
    const Differences d = central_differences(q, std::ldexp(h0, -k), energy);
    g_errors.push_back((d.g - g).norm());
    hess_errors.push_back((d.hess - hess).norm());
    largest_V = std::max(largest_V, d.largest_V);
    largest_g = std::max(largest_g, d.largest_g);
    largest_hess = std::max(largest_hess, d.largest_hess);
  }
  const double unit = 4 * static_cast<double>(q.size()) * std::numeric_limits<double>::epsilon();
  expect_order(g_errors, h0, order, unit * (largest_V + largest_g * q.norm()), "gradient");
  expect_order(hess_errors, h0, order, unit * (largest_g + largest_hess * q.norm()), "Hessian");
}

}  // namespace slipstitch::testing
