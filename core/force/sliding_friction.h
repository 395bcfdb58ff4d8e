// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Stick-slip on every sliding coordinate u with an anchored spring, s = u - anchor:
///   Phi(s) = 1/2 k_f s^2                        while k_f |s| <= mu F_n,
///            mu F_n |s| - (mu F_n)^2 / (2 k_f)  beyond; convex, C1.
/// F_n is estimated from the yarns' forces at the start of the step and held during it (contact_force.h), or given.
/// After the step the anchor is dragged so that k_f |s| <= mu F_n. [Cirio et al. 2017, sliding friction]
class SlidingFriction {
 public:
  static constexpr int kSize = 1;
  static constexpr std::string_view kName = "sliding_friction";

  explicit SlidingFriction(const Model& model);
  int size() const { return static_cast<int>(visit_.size()); }
  std::array<int, kSize> coords(int k) const { return {first_arc_coord_ + visit_[static_cast<std::size_t>(k)]}; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);

  /// Anchors after a step that ended at q (num_visits).
  void drag_anchors(const VecX& q, VecX& anchor) const;
  /// Limits mu F_n of this step [N] (size), for reports.
  const std::vector<double>& limits() const { return limit_; }

 private:
  double explicit_eval(std::size_t k, double u, Vec<kSize>* g, Mat<kSize>* hess) const;

  const Model* model_ = nullptr;  // outlives the pool
  int first_arc_coord_ = 0;
  double mu_ = 0.0, k_f_ = 0.0;
  std::vector<int> visit_;      // (size)
  std::vector<double> anchor_;  // [m] (size)
  std::vector<double> limit_;   // mu F_n [N] (size)
  std::vector<double> naive_force_;  // [N] (size); empty: see Naive::explicit_friction
};
static_assert(ForceTerm<SlidingFriction>);

}  // namespace slipstitch
