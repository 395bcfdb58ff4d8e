// SPDX-License-Identifier: MIT
#include "collide/shape_distance.h"

#include <algorithm>
#include <limits>

#include "collide/closest_point.h"

namespace slipstitch {
namespace {

/// Distance from a point that a surface of radius r surrounds.
Distance around(const Vec3& centre, double r, const Vec3& p) {
  const Vec3 d = p - centre;
  const double length = d.norm();
  if (!(length > 0.0)) return {-r, Vec3::UnitY(), Mat3::Zero()};
  const Vec3 n = d / length;
  return {length - r, n, (Mat3::Identity() - n * n.transpose()) / length};
}

/// In the box's frame, inside: the nearest face.
Distance to_nearest_face(const Vec3& half, const Vec3& p) {
  int axis = 0;
  const Vec3 depth = p.cwiseAbs() - half;
  depth.maxCoeff(&axis);
  Distance d{depth[axis], Vec3::Zero(), Mat3::Zero()};
  d.normal[axis] = p[axis] < 0.0 ? -1.0 : 1.0;
  return d;
}

}  // namespace

Distance distance_to(const Plane& plane, const Vec3& p) {
  const Vec3 n = plane.normal.normalized();
  return {n.dot(p - plane.point), n, Mat3::Zero()};
}

Distance distance_to(const Sphere& sphere, const Vec3& p) { return around(sphere.centre, sphere.radius, p); }

Distance distance_to(const Capsule& capsule, const Vec3& p) {
  const Vec3 c = closest_on_segment(p, capsule.a, capsule.b);
  Distance d = around(c, capsule.radius, p);
  if (c != capsule.a && c != capsule.b) {  // beside the cylinder: straight along its axis
    const Vec3 axis = (capsule.b - capsule.a).normalized();
    d.curvature -= axis * axis.transpose() / (d.phi + capsule.radius);
  }
  return d;
}

Distance distance_to(const Box& box, const Vec3& p) {
  const Mat3 turn = turn_by(box.rotation_rad);
  const Vec3 local = turn.transpose() * (p - box.centre);
  const Vec3 nearest = local.cwiseMax(-box.half_size).cwiseMin(box.half_size);
  Distance d;
  if (nearest == local) {
    d = to_nearest_face(box.half_size, local);
  } else {
    const Vec3 away = local - nearest;
    d.phi = away.norm();
    d.normal = away / d.phi;
    for (int i = 0; i < 3; ++i)
      if (away[i] != 0.0) d.curvature(i, i) = 1.0;  // beyond an edge or a corner the surface is round
    d.curvature = (d.curvature - d.normal * d.normal.transpose()) / d.phi;
  }
  d.normal = turn * d.normal;
  d.curvature = turn * d.curvature * turn.transpose();
  return d;
}

}  // namespace slipstitch
