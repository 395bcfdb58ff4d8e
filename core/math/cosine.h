// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "math/types.h"

namespace slipstitch {

/// The angle theta in [0, pi] between d1 and d2, and the derivatives of its cosine with respect to (d1, d2).
/// Cross-product forms: no difference of nearly equal vectors near 0 and pi. Neither vector may be 0.
struct Cosine {
  double l1, l2;  // lengths
  Vec3 t1, t2;    // directions
  double c, s;    // cosine and sine, s >= 0
  Vec3 s1, s2;    // t2 - c t1 and t1 - c t2

  Cosine(const Vec3& d1, const Vec3& d2) : l1(d1.norm()), l2(d2.norm()), t1(d1 / l1), t2(d2 / l2), c(t1.dot(t2)) {
    const Vec3 n = t1.cross(t2);
    s = n.norm();
    s1 = n.cross(t1);
    s2 = t2.cross(n);
  }

  double theta() const { return std::atan2(s, c); }

  Vec<6> gradient() const {
    Vec<6> g;
    g << s1 / l1, s2 / l2;
    return g;
  }

  Mat<6> hessian() const {
    const Mat3 P1 = Mat3::Identity() - t1 * t1.transpose();
    const Mat3 P2 = Mat3::Identity() - t2 * t2.transpose();
    Mat<6> h;
    h.block<3, 3>(0, 0) = -(t1 * s1.transpose() + s1 * t1.transpose() + c * P1) / (l1 * l1);
    h.block<3, 3>(3, 3) = -(t2 * s2.transpose() + s2 * t2.transpose() + c * P2) / (l2 * l2);
    h.block<3, 3>(0, 3) = P1 * P2 / (l1 * l2);
    h.block<3, 3>(3, 0) = h.block<3, 3>(0, 3).transpose();
    return h;
  }
};

}  // namespace slipstitch
