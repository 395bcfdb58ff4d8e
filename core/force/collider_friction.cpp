// SPDX-License-Identifier: MIT
#include "force/collider_friction.h"

#include <algorithm>

#include "force/weighted_point.h"

namespace slipstitch {

void ColliderFriction::begin_step(const StepContext& step) {
  if (bodies_.empty()) return;
  if (!same_pairs(touches_, step.start.touches)) ++revision_;
  touches_ = step.start.touches;
  for (RigidBody& body : bodies_) body.move_to(step.end_t());
  stencils_.clear();
  for (const Touch& touch : touches_) {
    const RigidBody& body = bodies_[static_cast<std::size_t>(touch.body)];
    const Vec3 anchor = body.to_space(touch.anchor);
    stencils_.push_back({parts_->samples[touch.sample],
                         {anchor, body.distance(anchor).normal, parts_->k_t, body.friction() * touch.normal_force}});
  }
}

double ColliderFriction::eval(int k, const Vec<6>& q, Vec<6>* g, Mat<6>* hess) const {
  const Stencil& at = stencils_[static_cast<std::size_t>(k)];
  const std::array<double, 2> w{1.0 - at.sample.share, at.sample.share};
  const StickSlip::Pull pull = at.hold.pull(w[0] * q.head<3>() + w[1] * q.tail<3>());
  if (g) *g << w[0] * pull.force_over_way * pull.way, w[1] * pull.force_over_way * pull.way;
  if (hess) spread(w, pull.stiffness, *hess);
  return pull.value;
}

std::vector<Touch> ColliderFriction::touches_at(const ColliderContact& contact, const VecX& q) const {
  std::vector<Touch> touches;
  for (const auto& pair : contact.pairs()) {
    const RigidBody& body = contact.body(pair.body);
    const double force = body.friction() > 0.0 ? contact.normal_force(pair, q) : 0.0;
    if (!(force > 0.0)) continue;
    const Vec3 x = place_of(contact.sample(pair.sample), q);
    Touch touch{pair.sample, pair.body, x, force};
    const auto last = std::lower_bound(touches_.begin(), touches_.end(), touch, before);
    if (last != touches_.end() && !before(touch, *last))
      touch.anchor = stencils_[static_cast<std::size_t>(last - touches_.begin())].hold.dragged(x);
    touch.anchor = body.to_body(touch.anchor);
    touches.push_back(touch);
  }
  std::sort(touches.begin(), touches.end(), before);
  return touches;
}

}  // namespace slipstitch
