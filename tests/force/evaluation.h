// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "math/types.h"

namespace slipstitch::testing {

using MatX = Eigen::MatrixXd;

/// energy(q, g, hess) with sizes known at run time, so that a check is compiled once and not once a term.
using Energy = std::function<double(const VecX& q, VecX* g, MatX* hess)>;

template <int N, class FixedEnergy>
Energy with_dynamic_size(FixedEnergy energy) {
  return [energy](const VecX& q, VecX* g, MatX* hess) {
    Vec<N> fixed_g;
    Mat<N> fixed_hess;
    const double V = energy(Vec<N>(q), g ? &fixed_g : nullptr, hess ? &fixed_hess : nullptr);
    if (g) *g = fixed_g;
    if (hess) *hess = fixed_hess;
    return V;
  };
}

}  // namespace slipstitch::testing
