// SPDX-License-Identifier: MIT
#include "force/touch_parts.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {
namespace {

constexpr double kDeepest = 0.1;     // overlap, in yarn radii
constexpr double kStiffness = 1e-3;  // of EA
// How much deeper a body reaches between points than at them, in yarn radii.
constexpr double kBallBetween = 0.01, kEdgeBetween = 0.15;

/// Of points on a straight yarn between which a body of this radius reaches `between` deeper [m].
double spacing_for(double body_radius, double between, double radius) {
  return std::min(2.0 * radius, std::sqrt(8.0 * between * radius * (body_radius + radius)));
}

}  // namespace

SharedTouchParts touch_parts(const Model& model) {
  auto parts = std::make_shared<TouchParts>();
  const auto& effect = model.effects.colliders;
  if (!effect) return parts;
  parts->radius = model.yarn.radius_m;
  parts->depth = kDeepest * parts->radius;
  parts->ball_depth = (kDeepest - 2.0 * kBallBetween) * parts->radius;  // twice: for yarn that is stretched
  parts->k = effect->stiffness_n.value_or(kStiffness * model.yarn.stretch_n);
  parts->k_t = effect->stick_stiffness_n_per_m;
  double spacing = 2.0 * parts->radius, ball_spacing = spacing;
  for (const Collider& collider : effect->colliders) {
    const double edge = edge_radius(collider.shape);
    double& narrowest = collider.dynamic ? ball_spacing : spacing;
    narrowest = std::min(narrowest, spacing_for(edge, collider.dynamic ? kBallBetween : kEdgeBetween, parts->radius));
    if (!collider.dynamic) parts->bodies.emplace_back(collider);
  }
  if (!parts->bodies.empty()) parts->samples = TouchSamples(model, spacing, TouchPoints::free);
  if (!model.bodies.empty()) parts->all_samples = TouchSamples(model, ball_spacing, TouchPoints::all);
  return parts;
}

bool before(const Touch& a, const Touch& b) { return a.sample != b.sample ? a.sample < b.sample : a.body < b.body; }

bool same_pairs(const std::vector<Touch>& a, const std::vector<Touch>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Touch& x, const Touch& y) { return !before(x, y) && !before(y, x); });
}

}  // namespace slipstitch
