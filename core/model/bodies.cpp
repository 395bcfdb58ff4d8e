// SPDX-License-Identifier: MIT
#include "model/bodies.h"

namespace slipstitch {
namespace {

/// `full` with three more coordinates behind the first `positions`.
VecX with_position(const VecX& full, Eigen::Index positions, const Vec3& added) {
  VecX longer(full.size() + 3);
  longer << full.head(positions), added, full.tail(full.size() - positions);
  return longer;
}

}  // namespace

void append_bodies(Model& model) {
  if (!model.effects.colliders) return;
  const std::vector<Collider>& colliders = model.effects.colliders->colliders;
  for (int i = 0; i < static_cast<int>(colliders.size()); ++i) {
    const Collider& collider = colliders[static_cast<std::size_t>(i)];
    if (!collider.dynamic) continue;
    const Sphere& sphere = std::get<Sphere>(collider.shape);
    const int positions = 3 * model.topology.num_nodes;
    model.bodies.push_back({i, model.topology.num_nodes, collider.dynamic->mass_kg, sphere.radius, collider.friction});
    model.start_q = with_position(model.start_q, positions, sphere.centre);
    model.start_v = with_position(model.start_v, positions, collider.dynamic->velocity_m_per_s);
    ++model.topology.num_nodes;
    ++model.topology.num_bodies;
  }
}

}  // namespace slipstitch
