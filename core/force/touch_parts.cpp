// SPDX-License-Identifier: MIT
#include "force/touch_parts.h"

#include <algorithm>
#include <cmath>

namespace slipstitch {
namespace {

constexpr double kDeepest = 0.1;     // overlap, in yarn radii
constexpr double kStiffness = 1e-3;  // of EA
constexpr double kBetween = 0.01;    // how much deeper a sphere reaches between points than at them, in yarn radii

double spacing_for(const std::vector<Body>& bodies, double radius) {
  double spacing = 2.0 * radius;
  for (const Body& body : bodies)
    spacing = std::min(spacing, std::sqrt(8.0 * kBetween * radius * (body.radius_m + radius)));
  return spacing;
}

}  // namespace

SharedTouchParts touch_parts(const Model& model) {
  auto parts = std::make_shared<TouchParts>();
  const auto& effect = model.effects.colliders;
  if (!effect) return parts;
  parts->radius = model.yarn.radius_m;
  parts->depth = kDeepest * parts->radius;
  parts->ball_depth = (kDeepest - 2.0 * kBetween) * parts->radius;  // twice: for yarn that is stretched
  parts->k = effect->stiffness_n.value_or(kStiffness * model.yarn.stretch_n);
  parts->k_t = effect->stick_stiffness_n_per_m;
  for (const Collider& collider : effect->colliders)
    if (!collider.dynamic) parts->bodies.emplace_back(collider);
  if (!parts->bodies.empty()) parts->samples = TouchSamples(model, 2.0 * parts->radius, TouchPoints::free);
  if (!model.bodies.empty())
    parts->all_samples =
        TouchSamples(model, spacing_for(model.bodies, parts->radius), TouchPoints::all);
  return parts;
}

bool before(const Touch& a, const Touch& b) { return a.sample != b.sample ? a.sample < b.sample : a.body < b.body; }

bool same_pairs(const std::vector<Touch>& a, const std::vector<Touch>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Touch& x, const Touch& y) { return !before(x, y) && !before(y, x); });
}

}  // namespace slipstitch
