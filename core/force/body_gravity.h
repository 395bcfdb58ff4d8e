// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Weight of the dynamic spheres, V = -m g.x.
class BodyGravity {
 public:
  static constexpr int kSize = 3;
  static constexpr std::string_view kName = "body_gravity";

  explicit BodyGravity(const Model& model);
  int size() const { return static_cast<int>(bodies_.size()); }
  std::array<int, kSize> coords(int k) const {
    const int x = 3 * bodies_[static_cast<std::size_t>(k)].node;
    return {x, x + 1, x + 2};
  }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext&) {}

 private:
  Vec3 acceleration_ = Vec3::Zero();
  std::vector<Body> bodies_;
};
static_assert(ForceTerm<BodyGravity>);

}  // namespace slipstitch
