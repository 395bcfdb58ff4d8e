// SPDX-License-Identifier: MIT
#include "gauntlet/wrap_reference.h"

#include <boost/math/constants/constants.hpp>

namespace slipstitch::testing {
namespace {

Real pi() { return boost::math::constants::pi<Real>(); }

Real step(const Real& x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  return x * x * x * (x * (6 * x - 15) + 10);
}

Real sine(const Real3& a, const Real3& b) { return length(cross(a, b)) / (length(a) * length(b)); }

// int_0^t y (1 - S((y - pi + w)/w)) dy beyond pi - w, else t^2/2.
Real well(const Real& t) {
  const Real w = kWrapCapWidth, start = Real(kPi) - w, r = abs(t);
  if (r <= start) return t * t / 2;
  const Real x = r < Real(kPi) ? Real((r - start) / w) : Real(1);
  const Real area = x - pow(x, 4) * (Real(5) / 2 - 3 * x + x * x);
  const Real moment = x * x / 2 - pow(x, 5) * (2 - Real(5) / 2 * x + Real(6) / 7 * x * x);
  return start * start / 2 + w * (start * area + w * moment);
}

}  // namespace

Vec<12> Hinge::at(double psi) const {
  Vec<12> q = Vec<12>::Zero();
  q[3] = axis;
  q.segment<3>(6) = Vec3(foot_b, -height_b * std::cos(psi), -height_b * std::sin(psi));
  q.segment<3>(9) = Vec3(foot_a, height_a, 0.0);
  return kRestLength * q;
}

Vec<12> Hinge::turned(double psi) const {
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -2) / 3).toRotationMatrix();
  Vec<12> q = at(psi);
  for (int n = 0; n < 4; ++n) q.segment<3>(3 * n) = turn * Vec3(q.segment<3>(3 * n));
  return q;
}

Real real_wrap_angle(const Reals& q) {
  const Real3 x0 = point(q, 0), x1 = point(q, 3), x3 = point(q, 6), x4 = point(q, 9);
  const Real3 na = cross(x4 - x1, x0 - x1), nb = cross(x0 - x1, x3 - x1);
  const Real3 axis = x1 - x0;
  return atan2(dot(axis, cross(na, nb)) / length(axis), dot(na, nb));
}

Real real_wrapping_energy(const Wrap& wrap, double offset, const Reals& q) {
  const Real3 axis = point(q, 3) - point(q, 0), a = point(q, 9) - point(q, 0), b = point(q, 6) - point(q, 3);
  Real fade = step(sine(axis, a) / Real(kWrapFadeSine)) * step(sine(axis, b) / Real(kWrapFadeSine));
  for (const Real3& edge : {axis, a, b}) fade *= step(length(edge) / (Real(kWrapFadeLength) * Real(wrap.L)));
  Real t = real_wrap_angle(q) - Real(wrap.rest);
  if (t > pi()) t -= 2 * pi();
  if (t <= -pi()) t += 2 * pi();
  return Real(wrap.k) * fade * (well(t) + Real(offset));
}

}  // namespace slipstitch::testing
