// SPDX-License-Identifier: MIT
#include "collide/closest_point.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {

Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double length2 = d.squaredNorm();
  if (!(length2 > 0.0)) return a;
  return a + std::clamp((p - a).dot(d) / length2, 0.0, 1.0) * d;
}

TrianglePoint closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, Feature::a};
  if (d3 >= 0.0 && d4 <= d3) return {b, Feature::b};
  if (d6 >= 0.0 && d5 <= d6) return {c, Feature::c};
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, Feature::ab};
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, Feature::ca};
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), Feature::bc};
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, Feature::face};
}

SegmentPair closest_of_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const auto inside = [](double x) { return std::clamp(x, 0.0, 1.0); };
  if (!(a > 0.0) && !(e > 0.0)) return {0.0, 0.0};
  if (!(a > 0.0)) return {0.0, inside(f / e)};
  if (!(e > 0.0)) return {inside(-c / a), 0.0};
  const double denominator = a * e - b * b;
  const double s = denominator > 1e-14 * a * e ? inside((b * f - c * e) / denominator) : 0.0;
  const double t = (b * s + f) / e;
  if (t < 0.0) return {inside(-c / a), 0.0};
  if (t > 1.0) return {inside((b - c) / a), 1.0};
  return {s, t};
}

double first_reach(const Vec3& p, const Vec3& dp, double floor) {
  const double a = dp.squaredNorm(), b = p.dot(dp), c = p.squaredNorm() - floor * floor;
  if (!(b < 0.0)) return 1.0;
  const double root = b * b - a * c;
  if (root < 0.0) return 1.0;
  return std::clamp(c / (-b + std::sqrt(root)), 0.0, 1.0);
}

}  // namespace slipstitch
