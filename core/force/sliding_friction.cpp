// SPDX-License-Identifier: MIT
#include "force/sliding_friction.h"

#include <cmath>

#include "force/contact_force.h"

namespace slipstitch {

SlidingFriction::SlidingFriction(const Model& model) : model_(&model), first_arc_coord_(model.topology.arc_coord(0)) {
  if (!model.effects.sliding || !model.effects.sliding_friction) return;
  mu_ = model.effects.sliding_friction->coefficient;
  k_f_ = model.effects.sliding_friction->stick_stiffness_n_per_m;
  for (int i = 0; i < model.topology.num_visits(); ++i)
    if (model.topology.visit_slides[static_cast<std::size_t>(i)] && model.topology.owned(i)) visit_.push_back(i);
  anchor_.resize(visit_.size());
  limit_.resize(visit_.size());
  if (model.naive.explicit_friction) naive_force_.resize(visit_.size());
}

void SlidingFriction::begin_step(const StepContext& step) {
  if (visit_.empty()) return;
  const auto& given = model_->effects.sliding_friction->normal_force_n;
  const std::vector<double> normal = given ? std::vector<double>() : estimate_normal_forces(*model_, step.start);
  for (std::size_t k = 0; k < visit_.size(); ++k) {
    anchor_[k] = step.start.anchor[visit_[k]];
    limit_[k] = mu_ * (given ? *given : normal[static_cast<std::size_t>(visit_[k])]);
    if (naive_force_.empty()) continue;
    const double rate = step.start.v[first_arc_coord_ + visit_[k]];
    naive_force_[k] = rate == 0.0 ? 0.0 : std::copysign(limit_[k], rate);
  }
}

double SlidingFriction::eval(int k, const Vec<1>& q, Vec<1>* g, Mat<1>* hess) const {
  const auto i = static_cast<std::size_t>(k);
  if (!naive_force_.empty()) [[unlikely]] return explicit_eval(i, q[0], g, hess);
  const double s = q[0] - anchor_[i];
  const double limit = limit_[i];
  const bool sticks = k_f_ * std::abs(s) <= limit;
  if (g) (*g)[0] = sticks ? k_f_ * s : std::copysign(limit, s);
  if (hess) (*hess)(0, 0) = sticks ? k_f_ : 0.0;
  return sticks ? 0.5 * k_f_ * s * s : limit * std::abs(s) - limit * limit / (2.0 * k_f_);
}

double SlidingFriction::explicit_eval(std::size_t k, double u, Vec<1>* g, Mat<1>* hess) const {
  if (g) (*g)[0] = naive_force_[k];
  if (hess) hess->setZero();
  return naive_force_[k] * (u - anchor_[k]);
}

void SlidingFriction::drag_anchors(const VecX& q, VecX& anchor) const {
  for (std::size_t k = 0; k < visit_.size(); ++k) {
    const double s = q[first_arc_coord_ + visit_[k]] - anchor_[k];
    const double reach = limit_[k] / k_f_;
    anchor[visit_[k]] = std::abs(s) > reach ? q[first_arc_coord_ + visit_[k]] - std::copysign(reach, s) : anchor_[k];
  }
}

}  // namespace slipstitch
