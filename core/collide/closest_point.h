// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "math/types.h"

namespace slipstitch {

/// Closest point of a segment, and of a triangle. Source: Ericson, Real-Time Collision Detection, 2005, 5.1.
Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Which part of a triangle is closest: corners a, b, c, edges ab, bc, ca, or the inside.
enum class Feature { a, b, c, ab, bc, ca, face };
struct TrianglePoint {
  Vec3 point;
  Feature feature = Feature::face;
};
TrianglePoint closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// Closest points of two segments: shares s, t in [0, 1] of the way along p0 p1 and q0 q1.
struct SegmentPair {
  double s = 0.0, t = 0.0;
};
SegmentPair closest_of_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

/// First a in [0, 1] where |p + a dp| = floor, from outside; 1 if there is none.
double first_reach(const Vec3& p, const Vec3& dp, double floor);

}  // namespace slipstitch
