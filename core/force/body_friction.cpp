// SPDX-License-Identifier: MIT
#include "force/body_friction.h"

#include <algorithm>

#include "force/weighted_point.h"

namespace slipstitch {

void BodyFriction::begin_step(const StepContext& step) {
  if (bodies_.empty()) return;
  if (!same_pairs(touches_, step.start.body_touches)) ++revision_;
  touches_ = step.start.body_touches;
  stencils_.clear();
  for (const Touch& touch : touches_) {
    const TouchSample& sample = parts_->all_samples[touch.sample];
    const Body& body = bodies_[static_cast<std::size_t>(touch.body)];
    Stencil& stencil = stencils_.emplace_back();
    std::copy(sample.coords.begin(), sample.coords.end(), stencil.coords.begin());
    for (int c = 0; c < 3; ++c) stencil.coords[static_cast<std::size_t>(6 + c)] = 3 * body.node + c;
    stencil.share = sample.share;
    stencil.hold = {touch.anchor, touch.anchor.normalized(), parts_->k_t, body.friction * touch.normal_force};
  }
}

double BodyFriction::eval(int k, const Vec<9>& q, Vec<9>* g, Mat<9>* hess) const {
  const Stencil& at = stencils_[static_cast<std::size_t>(k)];
  const std::array<double, 3> w{1.0 - at.share, at.share, -1.0};
  const StickSlip::Pull pull = at.hold.pull(w[0] * q.segment<3>(0) + w[1] * q.segment<3>(3) + w[2] * q.segment<3>(6));
  if (g)
    for (std::size_t i = 0; i < 3; ++i)
      g->segment<3>(static_cast<Eigen::Index>(3 * i)) = w[i] * pull.force_over_way * pull.way;
  if (hess) spread(w, pull.stiffness, *hess);
  return pull.value;
}

std::vector<Touch> BodyFriction::touches_at(const BodyContact& contact, const VecX& q) const {
  std::vector<Touch> touches;
  for (const auto& pair : contact.pairs()) {
    const double force = contact.body(pair.body).friction > 0.0 ? contact.normal_force(pair, q) : 0.0;
    if (!(force > 0.0)) continue;
    const Vec3 x = contact.from_centre(pair, q);
    Touch touch{pair.sample, pair.body, x, force};
    const auto last = std::lower_bound(touches_.begin(), touches_.end(), touch, before);
    if (last != touches_.end() && !before(touch, *last))
      touch.anchor = stencils_[static_cast<std::size_t>(last - touches_.begin())].hold.dragged(x);
    touches.push_back(touch);
  }
  std::sort(touches.begin(), touches.end(), before);
  return touches;
}

}  // namespace slipstitch
