// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "math/smoothstep.h"

namespace slipstitch {

/// b(x) = -(1 - x)^2 log x for 0 < x < 1, 0 from there on; convex, C2 and infinite at 0. [Li et al., "Incremental
/// potential contact", ACM TOG 39(4), 2020, eq. 6]
inline Jet2 log_barrier(double x) {
  if (x >= 1.0) return {0.0, 0.0, 0.0};
  if (!(x > 0.0)) return {std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const double log = std::log(x), y = 1.0 - x;
  return {-y * y * log, 2.0 * y * log - y * y / x, -2.0 * log + 4.0 * y / x + y * y / (x * x)};
}

}  // namespace slipstitch
