// SPDX-License-Identifier: MIT
#include "scene_io/convert_parts.h"

namespace slipstitch {
namespace {

std::string indexed(const std::string& path, int index) { return path + "[" + std::to_string(index) + "]"; }

TriangleMesh mesh_from(const v1::TriangleMesh& message, const std::string& path, Issues& issues) {
  TriangleMesh mesh;
  const auto in_threes = [&](int size, const char* field) {
    if (size % 3 == 0) return true;
    issues.push_back({path + "." + field, "an array of " + std::to_string(size), "a multiple of 3 numbers"});
    return false;
  };
  if (!in_threes(message.vertices_m_size(), "vertices_m") || !in_threes(message.triangles_size(), "triangles"))
    return mesh;
  for (int i = 0; i < message.vertices_m_size(); i += 3)
    mesh.vertices.emplace_back(message.vertices_m(i), message.vertices_m(i + 1), message.vertices_m(i + 2));
  for (int i = 0; i < message.triangles_size(); i += 3)
    mesh.triangles.push_back({message.triangles(i), message.triangles(i + 1), message.triangles(i + 2)});
  return mesh;
}

Shape shape_from(const v1::Collider& message, const std::string& path, Issues& issues) {
  const Vec3 zero = Vec3::Zero();
  const auto vector = [&](const Doubles& numbers, const Vec3& otherwise, const std::string& field) {
    return vector_from(numbers, otherwise, path + field, issues);
  };
  switch (message.shape_case()) {
    case v1::Collider::kPlane:
      return Plane{vector(message.plane().point_m(), zero, ".plane.point_m"),
                   vector(message.plane().normal(), Vec3::UnitY(), ".plane.normal")};
    case v1::Collider::kSphere:
      return Sphere{vector(message.sphere().centre_m(), zero, ".sphere.centre_m"), message.sphere().radius_m()};
    case v1::Collider::kCapsule:
      return Capsule{vector(message.capsule().a_m(), zero, ".capsule.a_m"),
                     vector(message.capsule().b_m(), zero, ".capsule.b_m"), message.capsule().radius_m()};
    case v1::Collider::kBox:
      return Box{vector(message.box().centre_m(), zero, ".box.centre_m"),
                 vector(message.box().half_size_m(), zero, ".box.half_size_m"),
                 vector(message.box().rotation_rad(), zero, ".box.rotation_rad")};
    case v1::Collider::kMesh:
      return mesh_from(message.mesh(), path + ".mesh", issues);
    case v1::Collider::SHAPE_NOT_SET:
      issues.push_back({path, "without a shape", "plane, sphere, capsule, box or mesh"});
  }
  return Plane{};
}

struct ShapeWriter {
  v1::Collider& message;

  void operator()(const Plane& plane) const {
    add_vector(plane.point, *message.mutable_plane()->mutable_point_m());
    add_vector(plane.normal, *message.mutable_plane()->mutable_normal());
  }
  void operator()(const Sphere& sphere) const {
    add_vector(sphere.centre, *message.mutable_sphere()->mutable_centre_m());
    message.mutable_sphere()->set_radius_m(sphere.radius);
  }
  void operator()(const Capsule& capsule) const {
    add_vector(capsule.a, *message.mutable_capsule()->mutable_a_m());
    add_vector(capsule.b, *message.mutable_capsule()->mutable_b_m());
    message.mutable_capsule()->set_radius_m(capsule.radius);
  }
  void operator()(const Box& box) const {
    add_vector(box.centre, *message.mutable_box()->mutable_centre_m());
    add_vector(box.half_size, *message.mutable_box()->mutable_half_size_m());
    add_vector(box.rotation_rad, *message.mutable_box()->mutable_rotation_rad());
  }
  void operator()(const TriangleMesh& mesh) const {
    for (const Vec3& vertex : mesh.vertices) add_vector(vertex, *message.mutable_mesh()->mutable_vertices_m());
    for (const auto& triangle : mesh.triangles)
      for (int vertex : triangle) message.mutable_mesh()->add_triangles(vertex);
  }
};

}  // namespace

std::vector<Keyframe> motion_from(const google::protobuf::RepeatedPtrField<v1::Keyframe>& message,
                                  const std::string& path, Issues& issues) {
  std::vector<Keyframe> motion;
  for (int i = 0; i < message.size(); ++i) {
    const std::string at = indexed(path, i);
    Keyframe& keyframe = motion.emplace_back();
    keyframe.t = message[i].t();
    keyframe.translation_m =
        vector_from(message[i].translation_m(), keyframe.translation_m, at + ".translation_m", issues);
    keyframe.rotation_rad = vector_from(message[i].rotation_rad(), keyframe.rotation_rad, at + ".rotation_rad", issues);
  }
  return motion;
}

void write_motion(const std::vector<Keyframe>& motion, google::protobuf::RepeatedPtrField<v1::Keyframe>& message) {
  for (const Keyframe& keyframe : motion) {
    v1::Keyframe& to = *message.Add();
    to.set_t(keyframe.t);
    add_vector(keyframe.translation_m, *to.mutable_translation_m());
    add_vector(keyframe.rotation_rad, *to.mutable_rotation_rad());
  }
}

namespace {

std::optional<DynamicBody> dynamic_from(const v1::Collider& message, const std::string& path, Issues& issues) {
  if (!message.has_dynamic()) return std::nullopt;
  return DynamicBody{message.dynamic().mass_kg(), vector_from(message.dynamic().velocity_m_per_s(), Vec3::Zero(),
                                                              path + ".velocity_m_per_s", issues)};
}

void write_dynamic(const DynamicBody& body, v1::DynamicBody& message) {
  message.set_mass_kg(body.mass_kg);
  add_vector(body.velocity_m_per_s, *message.mutable_velocity_m_per_s());
}

}  // namespace

CollidersEffect colliders_from(const v1::CollidersEffect& message, Issues& issues) {
  CollidersEffect effect;
  for (int i = 0; i < message.colliders_size(); ++i) {
    const std::string path = indexed("effects.colliders.colliders", i);
    const v1::Collider& from = message.colliders(i);
    Collider& collider = effect.colliders.emplace_back();
    collider.shape = shape_from(from, path, issues);
    if (from.has_friction_coefficient()) collider.friction = from.friction_coefficient();
    collider.motion = motion_from(from.motion(), path + ".motion", issues);
    collider.dynamic = dynamic_from(from, path + ".dynamic", issues);
  }
  if (message.has_stiffness_n()) effect.stiffness_n = message.stiffness_n();
  if (message.has_stick_stiffness_n_per_m()) effect.stick_stiffness_n_per_m = message.stick_stiffness_n_per_m();
  return effect;
}

void write_colliders(const CollidersEffect& effect, v1::CollidersEffect& message) {
  for (const Collider& collider : effect.colliders) {
    v1::Collider& to = *message.add_colliders();
    std::visit(ShapeWriter{to}, collider.shape);
    to.set_friction_coefficient(collider.friction);
    write_motion(collider.motion, *to.mutable_motion());
    if (collider.dynamic) write_dynamic(*collider.dynamic, *to.mutable_dynamic());
  }
  if (effect.stiffness_n) message.set_stiffness_n(*effect.stiffness_n);
  message.set_stick_stiffness_n_per_m(effect.stick_stiffness_n_per_m);
}

}  // namespace slipstitch
