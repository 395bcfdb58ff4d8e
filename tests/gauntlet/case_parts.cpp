// SPDX-License-Identifier: MIT
#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {

GauntletCase named(const std::string& name, const std::string& about, Scene scene) {
  GauntletCase item;
  item.name = name;
  item.about = about;
  item.scene = std::move(scene);
  return item;
}

Handle pin(Selector where) {
  Handle handle;
  handle.where = where;
  return handle;
}

Collider body(Shape shape, double friction) {
  Collider collider;
  collider.shape = std::move(shape);
  collider.friction = friction;
  return collider;
}

Scene swatch(int courses, int wales) {
  Scene scene = test::knit_scene("stockinette", courses, wales);
  test::use_demo_feel(scene.effects);
  scene.duration_s = 0.2;
  return scene;
}

void hang(Scene& scene) {
  scene.effects.gravity.emplace();
  scene.handles = {pin(Corner::top_left), pin(Corner::top_right)};
}

void put(Scene& scene, std::vector<Collider> colliders) {
  scene.effects.colliders.emplace().colliders = std::move(colliders);
}

std::function<void(Model&)> placed(std::function<Vec3(const Vec3& x)> place) {
  return [place](Model& model) {
    for (int n = 0; n < model.topology.num_yarn_nodes(); ++n)
      model.start_q.segment<3>(3 * n) = place(model.start_q.segment<3>(3 * n));
  };
}

}  // namespace slipstitch::gauntlet
