// SPDX-License-Identifier: MIT
#include "sim/longest_step.h"

#include <algorithm>

#include "force/collider_contact.h"

namespace slipstitch {
namespace {

constexpr int kMaxTries = 40;
constexpr double kFarthestWay = 0.8;  // radii, of which Simulation::step() can get what was gone over out of the way
constexpr double kMargin = 0.99;      // so that an even way fits at the second look

/// Way of the body's point at p from one time to another.
double way_at(const RigidBody& from, const RigidBody& to, const Vec3& p) {
  return (to.to_space(from.to_body(p)) - p).norm();
}

/// In shares of what keeps each body on its side of the yarn: a radius, or half of that and the body's own.
double farthest_body_way(const Simulation& sim, double h) {
  const auto& colliders = sim.model().effects.colliders;
  if (!colliders) return 0.0;
  const VecX& q = sim.state().q;
  const double radius = sim.model().yarn.radius_m;
  const SharedTouchParts& parts = term_of<ColliderContact>(sim.forces()).parts();
  const TouchSamples& samples = parts->samples;
  double farthest = 0.0;
  std::size_t body = 0;  // of those that are not dynamic
  for (const Collider& collider : colliders->colliders) {
    if (collider.dynamic) continue;
    RigidBody from = parts->bodies[body++], to = from;
    if (collider.motion.empty()) continue;
    from.move_to(sim.state().t);
    to.move_to(sim.state().t + h);
    const double allowed = std::min(kFarthestWay * radius, 0.5 * (radius + edge_radius(collider.shape)));
    for (int i = 0; i < samples.size(); ++i) {
      if (!samples[i].in_use) continue;
      const Vec3 p = place_of(samples[i], q);
      const double way = way_at(from, to, p);
      if (way > allowed * std::max(farthest, 1.0) && from.distance(p).phi < 2.0 * (way + radius))
        farthest = way / allowed;
    }
  }
  return farthest;
}

/// Likewise.
double farthest_handle_way(const Simulation& sim, double h) {
  const Model& model = sim.model();
  if (!model.effects.self_collision && model.bodies.empty()) return 0.0;
  VecX moved = sim.state().q;
  apply_scripts(model, sim.state().t + h, moved);
  double farthest = 0.0;
  for (const ScriptedNodes& handle : model.handles)
    for (const int n : handle.nodes) farthest = std::max(farthest, (moved - sim.state().q).segment<3>(3 * n).norm());
  return farthest / (kFarthestWay * model.yarn.radius_m);
}

}  // namespace

double longest_step(const Simulation& sim, double h) {
  // Scripts need not be even within h: what stands still in the end has gone the faster before.
  for (int k = 0; k < kMaxTries; ++k) {
    const double way = std::max(farthest_body_way(sim, h), farthest_handle_way(sim, h));
    if (!(way > 1.0)) return h;
    h *= kMargin / way;
  }
  return h;
}

}  // namespace slipstitch
