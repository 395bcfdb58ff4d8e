// SPDX-License-Identifier: MIT
// Shapes of the bodies of random scenes, and their places.
#include "gauntlet/random_shapes.h"

#include <algorithm>
#include <limits>

namespace slipstitch::gauntlet {
namespace {

/// A box whose corners were knocked in.
TriangleMesh dented_box(Dice& dice, const Vec3& half_size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Vec3 side((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    mesh.vertices.push_back(dice.uniform(0.7, 1.0) * side.cwiseProduct(half_size));
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Least x.way of the points of a shape.
double nearest(const Plane& plane, const Vec3& way) { return plane.point.dot(way); }
double nearest(const Sphere& sphere, const Vec3& way) { return sphere.centre.dot(way) - sphere.radius; }
double nearest(const Capsule& capsule, const Vec3& way) {
  return std::min(capsule.a.dot(way), capsule.b.dot(way)) - capsule.radius;
}
double nearest(const Box& box, const Vec3& way) {
  return box.centre.dot(way) - (turn_by(box.rotation_rad).transpose() * way).cwiseAbs().dot(box.half_size);
}
double nearest(const TriangleMesh& mesh, const Vec3& way) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& x : mesh.vertices) least = std::min(least, x.dot(way));
  return least;
}

void shift(Plane& plane, const Vec3& by) { plane.point += by; }
void shift(Sphere& sphere, const Vec3& by) { sphere.centre += by; }
void shift(Capsule& capsule, const Vec3& by) { capsule.a += by, capsule.b += by; }
void shift(Box& box, const Vec3& by) { box.centre += by; }
void shift(TriangleMesh& mesh, const Vec3& by) {
  for (Vec3& x : mesh.vertices) x += by;
}

}  // namespace

Front front_of(const Model& model, const Vec3& way) {
  Front front{way, Vec3::Zero(), -std::numeric_limits<double>::infinity(), 0.0};
  const int nodes = model.topology.num_nodes;
  for (int n = 0; n < nodes; ++n) front.middle += model.start_q.segment<3>(3 * n) / nodes;
  for (int n = 0; n < nodes; ++n) {
    const Vec3 x = model.start_q.segment<3>(3 * n);
    front.end = std::max(front.end, x.dot(way));
    front.size = std::max(front.size, (x - front.middle).norm());
  }
  return front;
}

Shape random_shape(Draft& draft, const Front& front) {
  Dice& dice = draft.dice;
  const double least = 2.0 * draft.radius();  // no thinner than the yarn: such a wire may pass it
  const double most = std::max(2.0 * least, front.size);
  const auto size = [&] { return dice.log_uniform(least, most); };
  const auto half_size = [&] {
    const double x = size(), y = size(), z = size();
    return Vec3(x, y, z);
  };
  switch (dice.between(0, 4)) {
    case 0:
      return Plane{Vec3::Zero(), -front.way};
    case 1:
      return Sphere{Vec3::Zero(), size()};
    case 2: {
      const Vec3 half = size() * dice.direction();
      return Capsule{-half, half, size()};
    }
    case 3: {
      const Vec3 half = half_size();
      return Box{Vec3::Zero(), half, kPi * dice.unit() * dice.direction()};
    }
    default:
      return dented_box(dice, half_size());
  }
}

Shape moved_ahead(Shape shape, const Front& front, double ahead, const Vec3& beside) {
  std::visit([&](auto& body) { shift(body, beside + (ahead - nearest(body, front.way)) * front.way); }, shape);
  return shape;
}

}  // namespace slipstitch::gauntlet
