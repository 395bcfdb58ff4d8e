// SPDX-License-Identifier: MIT
#include "force/collider_friction.h"

#include <algorithm>

namespace slipstitch {
namespace {

/// Touches stand in this order.
bool before(const Touch& a, const Touch& b) { return a.sample != b.sample ? a.sample < b.sample : a.body < b.body; }

bool same_pairs(const std::vector<Touch>& a, const std::vector<Touch>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Touch& x, const Touch& y) { return !before(x, y) && !before(y, x); });
}

}  // namespace

ColliderFriction::ColliderFriction(const Model& model) {
  const auto& effect = model.effects.colliders;
  if (!effect) return;
  k_t_ = effect->stick_stiffness_n_per_m;
  for (const Collider& collider : effect->colliders) bodies_.emplace_back(collider);
  samples_ = touch_samples(model);
}

void ColliderFriction::begin_step(const StepContext& step) {
  if (bodies_.empty()) return;
  if (!same_pairs(touches_, step.start.touches)) ++revision_;
  touches_ = step.start.touches;
  for (RigidBody& body : bodies_) body.move_to(step.start.t + step.h);
  stencils_.clear();
  for (const Touch& touch : touches_) {
    const TouchSample& sample = samples_[static_cast<std::size_t>(touch.sample)];
    const RigidBody& body = bodies_[static_cast<std::size_t>(touch.body)];
    const Vec3 anchor = body.to_space(touch.anchor);
    stencils_.push_back({sample, anchor, body.distance(anchor).normal, body.friction() * touch.normal_force});
  }
}

double ColliderFriction::eval(int k, const Vec<6>& q, Vec<6>* g, Mat<6>* hess) const {
  const Stencil& at = stencils_[static_cast<std::size_t>(k)];
  const double w[2] = {1.0 - at.sample.share, at.sample.share};
  const Mat3 along = Mat3::Identity() - at.normal * at.normal.transpose();
  const Vec3 s = along * (w[0] * q.head<3>() + w[1] * q.tail<3>() - at.anchor);
  const double way = s.norm();
  const bool sticks = k_t_ * way <= at.limit;
  const double force_over_way = sticks ? k_t_ : at.limit / way;
  if (g) *g << w[0] * force_over_way * s, w[1] * force_over_way * s;
  if (hess) {
    Mat3 block = force_over_way * along;
    if (!sticks) block -= force_over_way / (way * way) * s * s.transpose();
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) hess->block<3, 3>(3 * i, 3 * j) = w[i] * w[j] * block;
  }
  return sticks ? 0.5 * k_t_ * way * way : at.limit * way - at.limit * at.limit / (2.0 * k_t_);
}

std::vector<Touch> ColliderFriction::touches_at(const ColliderContact& contact, const VecX& q) const {
  std::vector<Touch> touches;
  for (const auto& pair : contact.pairs()) {
    const double force = contact.normal_force(pair, q);
    if (!(force > 0.0)) continue;
    const RigidBody& body = contact.body(pair.body);
    const Vec3 x = place_of(contact.sample(pair.sample), q);
    Touch touch{pair.sample, pair.body, x, force};
    const auto last = std::lower_bound(touches_.begin(), touches_.end(), touch, before);
    if (last != touches_.end() && !before(touch, *last)) {
      const Stencil& at = stencils_[static_cast<std::size_t>(last - touches_.begin())];
      const Vec3 s = x - at.anchor - at.normal * at.normal.dot(x - at.anchor);
      const double way = s.norm(), reach = at.limit / k_t_;
      touch.anchor = x - (way > reach ? reach / way : 1.0) * s;
    }
    touch.anchor = body.to_body(touch.anchor);
    touches.push_back(touch);
  }
  return touches;
}

}  // namespace slipstitch
