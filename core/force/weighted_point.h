// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "math/types.h"

namespace slipstitch {

/// Adds up to the point sum w_i q_i of N points q: the Hessian of f(that point) from that of f.
template <std::size_t N>
void spread(const std::array<double, N>& w, const Mat3& block, Mat<static_cast<int>(3 * N)>& hess) {
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j)
      hess.template block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)) =
          w[i] * w[j] * block;
}

}  // namespace slipstitch
