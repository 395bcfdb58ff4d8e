// SPDX-License-Identifier: MIT
#pragma once

#include "force/collider_contact.h"
#include "force/stick_slip.h"

namespace slipstitch {

/// StickSlip of touching points on rigid bodies, limit mu F_n. Normal force, surface and anchor are those of the start
/// of the step; the anchor rides on the body and is dragged behind a point that slips.
class ColliderFriction {
 public:
  static constexpr int kSize = 6;
  static constexpr std::string_view kName = "collider_friction";

  explicit ColliderFriction(const Model& model) : ColliderFriction(model, touch_parts(model)) {}
  ColliderFriction(const Model&, SharedTouchParts parts) : parts_(std::move(parts)), bodies_(parts_->bodies) {}
  int size() const { return static_cast<int>(stencils_.size()); }
  std::array<int, kSize> coords(int k) const { return stencils_[static_cast<std::size_t>(k)].sample.coords; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);
  const SharedTouchParts& parts() const { return parts_; }
  long revision() const { return revision_; }

  /// What touches at q where there is friction, with anchors carried over from this step's. `contact` must be at the
  /// end of the step.
  std::vector<Touch> touches_at(const ColliderContact& contact, const VecX& q) const;

 private:
  struct Stencil {
    TouchSample sample;
    StickSlip hold;
  };

  SharedTouchParts parts_;
  std::vector<RigidBody> bodies_;  // where they are at the end of the step
  std::vector<Touch> touches_;     // of the start of the step, one a stencil
  std::vector<Stencil> stencils_;
  long revision_ = 0;
};
static_assert(ForceTerm<ColliderFriction>);

}  // namespace slipstitch
