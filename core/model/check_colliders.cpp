// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "model/check_parts.h"

namespace slipstitch {
namespace {

/// A closed, consistently turned surface walks every directed edge once, and once back.
bool closed(const TriangleMesh& mesh) {
  std::vector<std::pair<int, int>> walks;
  walks.reserve(3 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) walks.insert(walks.end(), {{a, b}, {b, c}, {c, a}});
  std::sort(walks.begin(), walks.end());
  if (std::adjacent_find(walks.begin(), walks.end()) != walks.end()) return false;
  const auto walked_back = [&](const std::pair<int, int>& edge) {
    return std::binary_search(walks.begin(), walks.end(), std::pair(edge.second, edge.first));
  };
  return !walks.empty() && std::all_of(walks.begin(), walks.end(), walked_back);
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  const auto at = [&](int i) { return Vec3(mesh.vertices[static_cast<std::size_t>(i)] - mesh.vertices.front()); };
  for (const auto& [a, b, c] : mesh.triangles) sum += at(a).dot(at(b).cross(at(c))) / 6.0;
  return sum;
}

bool has_flat_triangle(const TriangleMesh& mesh) {
  const auto at = [&](int i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : mesh.triangles)
    if (!((at(b) - at(a)).cross(at(c) - at(a)).norm() > 0.0)) return true;
  return false;
}

struct CheckShape {
  const std::string& path;
  Checker& check;

  void operator()(const Plane& plane) const {
    check.finite(path + ".plane.point_m", plane.point);
    check.require(plane.normal.norm() > 0.0, path + ".plane.normal", plane.normal.norm(), "a vector that is not zero");
  }
  void operator()(const Sphere& sphere) const {
    check.finite(path + ".sphere.centre_m", sphere.centre);
    check.positive(path + ".sphere.radius_m", sphere.radius);
  }
  void operator()(const Capsule& capsule) const {
    check.finite(path + ".capsule.a_m", capsule.a);
    check.finite(path + ".capsule.b_m", capsule.b);
    check.positive(path + ".capsule.radius_m", capsule.radius);
    if (capsule.a == capsule.b)
      check.fail(path + ".capsule.b_m", "the same as a_m", "another point; for a ball, sphere");
  }
  void operator()(const Box& box) const {
    check.finite(path + ".box.centre_m", box.centre);
    check.finite(path + ".box.rotation_rad", box.rotation_rad);
    check.finite(path + ".box.half_size_m", box.half_size);
    check.require(box.half_size.minCoeff() > 0.0, path + ".box.half_size_m", box.half_size.minCoeff(),
                  "three numbers > 0");
  }
  void operator()(const TriangleMesh& mesh) const {
    const int vertices = static_cast<int>(mesh.vertices.size());
    bool usable = true;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      usable = usable && mesh.vertices[i].allFinite();
      check.finite(element(path + ".mesh.vertices_m", 3 * i), mesh.vertices[i]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const int vertex = mesh.triangles[i][k];
        usable = usable && vertex >= 0 && vertex < vertices;
        check.require_index(element(path + ".mesh.triangles", 3 * i + k), vertex, 0, vertices - 1);
      }
    if (!usable) return;
    const std::string triangles = std::to_string(mesh.triangles.size()) + " triangles";
    if (!closed(mesh)) {
      check.fail(path + ".mesh.triangles", triangles, "a closed surface: every edge in two triangles, once each way");
    } else if (has_flat_triangle(mesh)) {
      check.fail(path + ".mesh.triangles", triangles, "triangles with an area");
    } else if (!(volume(mesh) > 0.0)) {
      check.fail(path + ".mesh.triangles", triangles, "triangles that run counter-clockwise seen from outside");
    }
  }
};

constexpr std::array<const char*, std::variant_size_v<Shape>> kShapeWords{"plane", "sphere", "capsule", "box", "mesh"};

void check_dynamic(const Collider& collider, bool inertia, const std::string& path, Checker& check) {
  check.positive(path + ".mass_kg", collider.dynamic->mass_kg);
  check.finite(path + ".velocity_m_per_s", collider.dynamic->velocity_m_per_s);
  if (!std::holds_alternative<Sphere>(collider.shape))
    check.fail(path, std::string("given for a ") + kShapeWords[collider.shape.index()],
               "none: only a sphere can be dynamic");
  if (!collider.motion.empty()) check.fail(path, "given", "either motion or dynamic, not both");
  if (!inertia) check.fail(path, "given", "effects.inertia listed too: without it every step is at rest");
}

}  // namespace

void check_colliders(const CollidersEffect& effect, bool inertia, Checker& check) {
  if (effect.colliders.empty()) check.fail("effects.colliders.colliders", "empty", "at least one collider");
  for (std::size_t i = 0; i < effect.colliders.size(); ++i) {
    const std::string path = element("effects.colliders.colliders", i);
    std::visit(CheckShape{path, check}, effect.colliders[i].shape);
    check.not_negative(path + ".friction_coefficient", effect.colliders[i].friction);
    check_motion(effect.colliders[i].motion, path + ".motion", check);
    if (effect.colliders[i].dynamic) check_dynamic(effect.colliders[i], inertia, path + ".dynamic", check);
  }
  if (effect.stiffness_n) check.positive("effects.colliders.stiffness_n", *effect.stiffness_n);
  check.positive("effects.colliders.stick_stiffness_n_per_m", effect.stick_stiffness_n_per_m);
}

}  // namespace slipstitch
