// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <vector>

#include "math/types.h"

namespace slipstitch::testing {

/// Fifty decimal digits: what formulas give that a double can only come near to.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Real3 = std::array<Real, 3>;
using Reals = std::vector<Real>;
using RealEnergy = std::function<Real(const Reals& q)>;

Real3 operator-(const Real3& a, const Real3& b);
Real dot(const Real3& a, const Real3& b);
Real3 cross(const Real3& a, const Real3& b);
Real length(const Real3& a);
Real3 point(const Reals& q, int first);  // coordinates first, first + 1, first + 2
Real angle_between(const Real3& a, const Real3& b);

/// Energy, gradient and Hessian at q, rounded to double at the end: central differences with steps so far below
/// `near`, the distance to the nearest singularity in units of q, that they are right to 20 digits.
struct Reference {
  double V = 0.0;
  VecX g;
  Eigen::MatrixXd hess;
};
Reference reference(const RealEnergy& energy, const VecX& q, double near);

}  // namespace slipstitch::testing
