// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "math/types.h"
#include "model/motion.h"

namespace slipstitch {

/// Rigid bodies that yarn cannot enter. Sizes and places in m, in space at t = 0.

struct Plane {  // everything below it
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();  // not 0; any length
};
struct Sphere {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;  // > 0
};
struct Capsule {  // all points within `radius` of the segment a b
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double radius = 0.0;  // > 0
};
struct Box {
  Vec3 centre = Vec3::Zero(), half_size = Vec3::Zero();  // > 0 each
  Vec3 rotation_rad = Vec3::Zero();                      // axis * angle
};
struct TriangleMesh {  // closed, triangles counter-clockwise from outside
  std::vector<Vec3> vertices;
  std::vector<std::array<int, 3>> triangles;
};

using Shape = std::variant<Plane, Sphere, Capsule, Box, TriangleMesh>;

/// A body that forces move. It does not turn.
struct DynamicBody {
  double mass_kg = 0.0;                  // > 0
  Vec3 velocity_m_per_s = Vec3::Zero();  // at t = 0
};

struct Collider {
  Shape shape = Plane{};
  double friction = 0.3;                              // coefficient against the yarn >= 0
  std::vector<Keyframe> motion;                       // empty: fixed; rotation is about centre_of(shape)
  std::optional<DynamicBody> dynamic = std::nullopt;  // of spheres only, not together with motion; needs inertia
};

/// Plane: its point; box, sphere: the centre; capsule: its middle; mesh: the mean of its vertices.
Vec3 centre_of(const Shape& shape);

/// Of the sphere or capsule; 0 for what has edges, infinite for a plane [m].
double edge_radius(const Shape& shape);

}  // namespace slipstitch
