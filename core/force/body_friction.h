// SPDX-License-Identifier: MIT
#pragma once

#include "force/body_contact.h"
#include "force/stick_slip.h"

namespace slipstitch {

/// StickSlip of touching points on dynamic spheres, limit mu F_n, of the place of the point seen from the centre: what
/// counts is how the two move against each other. Normal force, surface and anchor are those of the start of the step.
class BodyFriction {
 public:
  static constexpr int kSize = 9;
  static constexpr std::string_view kName = "body_friction";

  explicit BodyFriction(const Model& model) : BodyFriction(model, touch_parts(model)) {}
  BodyFriction(const Model& model, SharedTouchParts parts) : parts_(std::move(parts)), bodies_(model.bodies) {}
  int size() const { return static_cast<int>(stencils_.size()); }
  std::array<int, kSize> coords(int k) const { return stencils_[static_cast<std::size_t>(k)].coords; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);
  const SharedTouchParts& parts() const { return parts_; }
  long revision() const { return revision_; }

  /// What touches at q where there is friction, with anchors carried over from this step's.
  std::vector<Touch> touches_at(const BodyContact& contact, const VecX& q) const;

 private:
  struct Stencil {
    std::array<int, kSize> coords{};
    double share = 0.0;
    StickSlip hold;  // seen from the centre
  };

  SharedTouchParts parts_;
  std::vector<Body> bodies_;
  std::vector<Touch> touches_;  // of the start of the step, one a stencil
  std::vector<Stencil> stencils_;
  long revision_ = 0;
};
static_assert(ForceTerm<BodyFriction>);

}  // namespace slipstitch
