// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// A function of one variable with its first two derivatives.
struct Jet2 {
  double f = 0.0, d = 0.0, dd = 0.0;
};

/// C2 step 6x^5 - 15x^4 + 10x^3: 0 for x <= 0, 1 for x >= 1.
inline Jet2 smoothstep(double x) {
  if (x <= 0.0) return {0.0, 0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0, 0.0};
  const double y = x * (1.0 - x);
  const double z = x <= 0.5 ? x : 1.0 - x;  // S(x) = 1 - S(1 - x); the polynomial cancels near 1
  const double half = z * z * z * (z * (6.0 * z - 15.0) + 10.0);
  return {x <= 0.5 ? half : 1.0 - half, 30.0 * y * y, 60.0 * y * (1.0 - 2.0 * x)};
}

}  // namespace slipstitch
