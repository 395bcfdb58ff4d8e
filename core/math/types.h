// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace slipstitch {

template <int N>
using Vec = Eigen::Matrix<double, N, 1>;
template <int N>
using Mat = Eigen::Matrix<double, N, N>;
using Vec3 = Vec<3>;
using Mat3 = Mat<3>;
using VecX = Eigen::VectorXd;

inline constexpr double kPi = std::numbers::pi;

}  // namespace slipstitch
