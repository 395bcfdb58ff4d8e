// SPDX-License-Identifier: MIT
#include "model/collider.h"

#include <limits>

namespace slipstitch {
namespace {

struct Centre {
  Vec3 operator()(const Plane& plane) const { return plane.point; }
  Vec3 operator()(const Sphere& sphere) const { return sphere.centre; }
  Vec3 operator()(const Capsule& capsule) const { return 0.5 * (capsule.a + capsule.b); }
  Vec3 operator()(const Box& box) const { return box.centre; }
  Vec3 operator()(const TriangleMesh& mesh) const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& vertex : mesh.vertices) sum += vertex;
    return sum / static_cast<double>(std::max<std::size_t>(1, mesh.vertices.size()));
  }
};

struct EdgeRadius {
  double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Box&) const { return 0.0; }
  double operator()(const TriangleMesh&) const { return 0.0; }
};

}  // namespace

Vec3 centre_of(const Shape& shape) { return std::visit(Centre{}, shape); }

double edge_radius(const Shape& shape) { return std::visit(EdgeRadius{}, shape); }

}  // namespace slipstitch
