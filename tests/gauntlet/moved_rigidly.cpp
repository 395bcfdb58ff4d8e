// SPDX-License-Identifier: MIT
#include "gauntlet/moved_rigidly.h"

#include <Eigen/Geometry>

namespace slipstitch::gauntlet {
namespace {

void turn_motion(std::vector<Keyframe>& motion, const RigidMove& move) {
  for (Keyframe& key : motion) {
    key.translation_m = move.turn * key.translation_m;
    key.rotation_rad = move.turn * key.rotation_rad;
  }
}

struct MoveShape {
  const RigidMove& move;
  void operator()(Plane& plane) const {
    plane.point = move.point(plane.point);
    plane.normal = move.turn * plane.normal;
  }
  void operator()(Sphere& sphere) const { sphere.centre = move.point(sphere.centre); }
  void operator()(Capsule& capsule) const {
    capsule.a = move.point(capsule.a);
    capsule.b = move.point(capsule.b);
  }
  void operator()(Box& box) const {
    box.centre = move.point(box.centre);
    const Eigen::AngleAxisd turned(Mat3(move.turn * turn_by(box.rotation_rad)));
    box.rotation_rad = turned.angle() * turned.axis();
  }
  void operator()(TriangleMesh& mesh) const {
    for (Vec3& vertex : mesh.vertices) vertex = move.point(vertex);
  }
};

void move_bodies(CollidersEffect& effect, const RigidMove& move) {
  for (Collider& collider : effect.colliders) {
    std::visit(MoveShape{move}, collider.shape);
    turn_motion(collider.motion, move);
    if (collider.dynamic) collider.dynamic->velocity_m_per_s = move.turn * collider.dynamic->velocity_m_per_s;
  }
}

}  // namespace

Model moved_rigidly(Model model, const RigidMove& move) {
  for (int n = 0; n < model.topology.num_nodes; ++n) {
    model.start_q.segment<3>(3 * n) = move.point(model.start_q.segment<3>(3 * n));
    model.start_v.segment<3>(3 * n) = (move.turn * model.start_v.segment<3>(3 * n)).eval();
  }
  for (ScriptedNodes& handle : model.handles) {
    turn_motion(handle.motion, move);
    handle.velocity_m_per_s = move.turn * handle.velocity_m_per_s;
  }
  for (Vec3& force : model.load_forces) force = (move.turn * force).eval();
  Effects& on = model.effects;
  if (on.gravity) on.gravity->acceleration_m_per_s2 = (move.turn * on.gravity->acceleration_m_per_s2).eval();
  if (on.wind) {
    on.wind->velocity_m_per_s = (move.turn * on.wind->velocity_m_per_s).eval();
    on.wind->gust_velocity_m_per_s = (move.turn * on.wind->gust_velocity_m_per_s).eval();
  }
  if (on.colliders) move_bodies(*on.colliders, move);
  return model;
}

}  // namespace slipstitch::gauntlet
