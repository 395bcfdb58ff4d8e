// SPDX-License-Identifier: MIT
#pragma once

#include "force/collider_contact.h"

namespace slipstitch {

/// Stick-slip on rigid bodies: with s the way that a touching point has gone from its anchor, along the surface,
/// V = 1/2 k_t s^2 while k_t s <= mu F_n, else mu F_n s - (mu F_n)^2 / (2 k_t). C1 and convex. Normal force, surface
/// and anchor are those of the start of the step; the anchor rides on the body and is dragged behind a point that
/// slips.
class ColliderFriction {
 public:
  static constexpr int kSize = 6;
  static constexpr std::string_view kName = "collider_friction";

  explicit ColliderFriction(const Model& model);
  int size() const { return static_cast<int>(stencils_.size()); }
  std::array<int, kSize> coords(int k) const { return stencils_[static_cast<std::size_t>(k)].sample.coords; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);
  long revision() const { return revision_; }

  /// What touches at q, with anchors carried over from this step's. `contact` must be at the end of the step.
  std::vector<Touch> touches_at(const ColliderContact& contact, const VecX& q) const;

 private:
  struct Stencil {
    TouchSample sample;
    Vec3 anchor = Vec3::Zero(), normal = Vec3::Zero();
    double limit = 0.0;  // mu F_n [N]
  };

  double k_t_ = 0.0;
  std::vector<RigidBody> bodies_;
  std::vector<TouchSample> samples_;
  std::vector<Touch> touches_;  // of the start of the step, one a stencil
  std::vector<Stencil> stencils_;
  long revision_ = 0;
};
static_assert(ForceTerm<ColliderFriction>);

}  // namespace slipstitch
