// SPDX-License-Identifier: MIT
#include "model/collider.h"

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

}  // namespace

Vec3 centre_of(const Shape& shape) { return std::visit(Centre{}, shape); }

}  // namespace slipstitch
