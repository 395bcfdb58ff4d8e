// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Inertia of the dynamic spheres: 1/2 m |d|^2 / h^2 - d.p_n / h, d the way of the centre since the start of the step.
class BodyInertia {
 public:
  static constexpr int kSize = 3;
  static constexpr std::string_view kName = "body_inertia";

  explicit BodyInertia(const Model& model);
  int size() const { return static_cast<int>(bodies_.size()); }
  std::array<int, kSize> coords(int k) const {
    const int x = 3 * bodies_[static_cast<std::size_t>(k)].node;
    return {x, x + 1, x + 2};
  }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);

  /// Writes m v into p (num_coords).
  void put_momentum(const VecX& v, VecX& p) const;
  double kinetic_energy(const VecX& v) const;  // [J]

 private:
  std::vector<Body> bodies_;
  double h_ = kNoStepYet;                     // [s]
  std::vector<Vec3> start_, start_momentum_;  // of every centre [m], p_n [kg m/s]
};
static_assert(ForceTerm<BodyInertia>);

}  // namespace slipstitch
