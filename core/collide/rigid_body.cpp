// SPDX-License-Identifier: MIT
#include "collide/rigid_body.h"

namespace slipstitch {
namespace {

template <class Shapes>
Shapes ready(const Shape& shape) {
  return std::visit(
      [](const auto& s) {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, TriangleMesh>)
          return Shapes(std::make_shared<const MeshDistance>(s));
        else
          return Shapes(s);
      },
      shape);
}

struct To {
  const Vec3& p;
  Distance operator()(const std::shared_ptr<const MeshDistance>& mesh) const { return (*mesh)(p); }
  template <class S>
  Distance operator()(const S& shape) const {
    return distance_to(shape, p);
  }
};

}  // namespace

RigidBody::RigidBody(const Collider& collider)
    : shape_(ready<Shapes>(collider.shape)),
      motion_(collider.motion),
      centre_(centre_of(collider.shape)),
      friction_(collider.friction) {
  move_to(0.0);
}

void RigidBody::move_to(double t) {
  const Keyframe pose = motion_at(motion_, t);
  translation_ = pose.translation_m;
  turn_ = turn_by(pose.rotation_rad);
}

Distance RigidBody::distance(const Vec3& p) const {
  Distance d = std::visit(To{to_body(p)}, shape_);
  if (motion_.empty()) return d;
  d.normal = turn_ * d.normal;
  d.curvature = turn_ * d.curvature * turn_.transpose();
  return d;
}

}  // namespace slipstitch
