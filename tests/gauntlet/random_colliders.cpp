// SPDX-License-Identifier: MIT
// Bodies that stand, move and fly beside the fabric of random scenes.
#include <algorithm>
#include <array>

#include "gauntlet/random_shapes.h"

namespace slipstitch::gauntlet {
namespace {

class Bodies {
 public:
  Bodies(Draft& draft, const Model& model) : draft_(draft), dice_(draft.dice), model_(model) {
    mass_ = model.topology.rest_arc.back() * draft.scene.yarn.linear_density_kg_per_m;
  }

  void draw() {
    std::vector<Collider>& colliders = draft_.scene.effects.colliders.emplace().colliders;
    if (dice_.chance(0.2))
      draft_.scene.effects.colliders->stiffness_n = draft_.scene.yarn.stretch_n * dice_.log_uniform(1e-4, 1e-2);
    draft_.scene.effects.colliders->stick_stiffness_n_per_m *= dice_.log_uniform(0.1, 10.0);
    const int count = dice_.between(1, 3);
    bool one_moves = false;  // two that move, or one that moves against one that stands, could press yarn to nothing
    for (int k = 0; k < count; ++k) {
      const Front front = front_of(model_, random_way());
      const double kind = dice_.unit();
      if (draft_.moves() && kind < 0.35) {
        colliders.push_back(flying(front));
      } else if (!one_moves && colliders.empty() && kind < 0.7) {
        colliders.push_back(moving(front));
        one_moves = true;
      } else if (!one_moves) {
        colliders.push_back(standing(front));
      }
    }
    if (colliders.empty()) draft_.scene.effects.colliders.reset();
  }

 private:
  Vec3 random_way() {
    const auto& gravity = draft_.scene.effects.gravity;
    if (gravity && dice_.chance(0.5)) return gravity->acceleration_m_per_s2.normalized();
    return dice_.direction();
  }

  /// The gap between the yarn's surface and the body's.
  double random_gap() { return draft_.radius() * dice_.log_uniform(0.2, 4.0); }

  Collider placed(Shape shape, const Front& front, double gap) {
    const Vec3 across = dice_.direction().cross(front.way);
    const Vec3 beside = 0.4 * front.size * dice_.unit() * across;
    const Vec3 aim = front.middle - front.middle.dot(front.way) * front.way + beside;
    Collider collider;
    collider.shape = moved_ahead(std::move(shape), front, front.end + draft_.radius() + gap, aim);
    collider.friction = dice_.chance(0.15) ? 0.0 : dice_.log_uniform(0.01, 10.0);
    draft_.say(std::array{"plane", "sphere", "capsule", "box", "mesh"}[collider.shape.index()]);
    return collider;
  }

  Collider standing(const Front& front) {
    const Shape shape = random_shape(draft_, front);
    const double gap = random_gap();
    // So that something comes of it.
    if (draft_.moves() && draft_.scene.handles.empty() && draft_.scene.initial_velocities.empty()) {
      const double speed = std::min(20.0, draft_.radius_a_step() * dice_.log_uniform(0.2, 2.0));
      draft_.scene.initial_velocities.push_back({AllNodes{}, speed * front.way});
    }
    return placed(shape, front, gap);
  }

  Collider moving(const Front& front) {
    const Shape shape = random_shape(draft_, front);
    const double gap = random_gap(), depth = draft_.radius() * dice_.log_uniform(0.5, 8.0);
    Collider collider = placed(shape, front, gap);
    const int keys = dice_.between(1, 3);
    for (int k = 1; k <= keys; ++k) {
      Keyframe key{draft_.duration_s() * k / keys, -(gap + depth) * k / keys * front.way, Vec3::Zero()};
      key.translation_m += 0.5 * depth * dice_.direction();
      if (dice_.chance(0.4)) key.rotation_rad = 0.5 * dice_.unit() * dice_.direction();
      collider.motion.push_back(key);
    }
    draft_.say("in motion");
    return collider;
  }

  /// Heavy ones may be as heavy and as fast as the yarn can bear.
  Collider flying(const Front& front) {
    const double radius = dice_.log_uniform(2.0 * draft_.radius(), std::max(4.0 * draft_.radius(), 0.5 * front.size));
    Collider collider = placed(Sphere{Vec3::Zero(), radius}, front, random_gap());
    DynamicBody& body = collider.dynamic.emplace();
    body.mass_kg = mass_ * dice_.log_uniform(1e-3, 30.0);
    const double speed = std::min(20.0, draft_.radius_a_step() * dice_.log_uniform(0.1, 2.0));
    body.velocity_m_per_s = -speed * front.way;
    draft_.say("flying");
    return collider;
  }

  Draft& draft_;
  Dice& dice_;
  const Model& model_;
  double mass_ = 0.0;  // of the last yarn: enough for a size [kg]
};

}  // namespace

void draw_colliders(Draft& draft, const Model& model) {
  if (draft.dice.chance(0.55)) Bodies(draft, model).draw();
}

}  // namespace slipstitch::gauntlet
