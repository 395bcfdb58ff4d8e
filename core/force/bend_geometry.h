// SPDX-License-Identifier: MIT
#pragma once

#include "math/cosine.h"
#include "math/types.h"

namespace slipstitch {

/// A function of the cosine c of the bend angle and of the arc length W = u1 - u2 over the bend.
struct BendFunction {
  double value = 0.0;
  double c = 0.0, W = 0.0;              // first derivatives
  double cc = 0.0, cW = 0.0, WW = 0.0;  // second derivatives
};

inline Cosine bend_cosine(const Vec<11>& q) {
  return Cosine(q.segment<3>(4) - q.segment<3>(0), q.segment<3>(7) - q.segment<3>(4));
}
inline double bend_arc(const Vec<11>& q) { return q[10] - q[3]; }

/// First and second derivative of theta^2 by c = cos theta.
struct SquaredAngle {
  double c = 0.0, cc = 0.0;
};
SquaredAngle squared_angle(const Cosine& cosine, double theta);

/// Chain rule from (c, W) to x2, u2, x0, x1, u1. g and hess may be null.
void bend_derivatives(const BendFunction& f, const Cosine& cosine, Vec<11>* g, Mat<11>* hess);

/// The parts of the Hessian of V(theta, W) that are never negative. Sliding along either segment is left out.
struct ConvexBend {
  double second = 0.0;  // d2V/dtheta2 >= 0
  double slope = 0.0;   // dV/dtheta; stiffens the yarn against bending out of its plane by slope cot(theta/2)/2
  double arc = 0.0;     // theta/W where V = W G(theta/W), 0 where V does not depend on W
};
void convex_bend_hessian(const ConvexBend& f, const Cosine& cosine, double theta, Mat<11>& hess);

}  // namespace slipstitch
