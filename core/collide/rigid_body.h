// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <variant>

#include "collide/mesh_distance.h"
#include "collide/shape_distance.h"

namespace slipstitch {

/// A collider at a time. Copies share a mesh.
class RigidBody {
 public:
  explicit RigidBody(const Collider& collider);

  void move_to(double t);
  Distance distance(const Vec3& p) const;
  Vec3 to_space(const Vec3& in_body) const { return turn_ * (in_body - centre_) + centre_ + translation_; }
  Vec3 to_body(const Vec3& in_space) const { return turn_.transpose() * (in_space - centre_ - translation_) + centre_; }
  double friction() const { return friction_; }

 private:
  using Shapes = std::variant<Plane, Sphere, Capsule, Box, std::shared_ptr<const MeshDistance>>;

  Shapes shape_;  // where it stands at t = 0
  std::vector<Keyframe> motion_;
  Vec3 centre_, translation_ = Vec3::Zero();
  Mat3 turn_ = Mat3::Identity();
  double friction_;
};

}  // namespace slipstitch
