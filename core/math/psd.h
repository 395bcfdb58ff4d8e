// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "math/types.h"

namespace slipstitch {

/// Whether every eigenvalue is >= 0 up to round-off, by LDLt with diagonal pivoting: for a semidefinite matrix no entry
/// of a Schur complement exceeds its largest diagonal entry. Non-finite input: false.
template <int N>
bool is_psd(Mat<N> a) {
  const double scale = a.diagonal().cwiseAbs().maxCoeff();
  const double tolerance = 8.0 * N * std::numeric_limits<double>::epsilon() * scale;
  for (int k = 0; k < N; ++k) {
    int pivot = k;
    double smallest = a(k, k);
    for (int i = k + 1; i < N; ++i) {
      if (a(i, i) > a(pivot, pivot)) pivot = i;
      smallest = std::min(smallest, a(i, i));
    }
    const double d = a(pivot, pivot);
    if (!(smallest >= -tolerance)) return false;
    if (!(d > tolerance)) {
      return a.bottomRightCorner(N - k, N - k).cwiseAbs().maxCoeff() <= tolerance;
    }
    if (pivot != k) {
      a.row(k).swap(a.row(pivot));
      a.col(k).swap(a.col(pivot));
    }
    for (int j = k + 1; j < N; ++j) {
      const double factor = a(j, k) / d;
      for (int i = j; i < N; ++i) {
        a(i, j) -= factor * a(i, k);
        a(j, i) = a(i, j);
      }
    }
  }
  return true;
}

/// Replaces a symmetric matrix by the nearest one (Frobenius) without negative eigenvalues. Returns whether it changed.
template <int N>
bool project_psd(Mat<N>& a) {
  if (is_psd<N>(a)) return false;
  const Eigen::SelfAdjointEigenSolver<Mat<N>> eigen(a);
  const Vec<N> clamped = eigen.eigenvalues().cwiseMax(0.0);
  a.noalias() = eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
  a = (0.5 * (a + a.transpose())).eval();
  return true;
}

}  // namespace slipstitch
