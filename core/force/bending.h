// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// V = k_b theta^2/W, theta in [0, pi] between x0 - x2 and x1 - x0, W = u1 - u2; k_b = EI [N m^2]. Order x2, u2, x0,
/// x1, u1 (the middle arc length does not enter). Cone at theta = pi, where the derivatives stay finite.
/// W <= 0: infinite energy, derivatives 0. No two neighbouring positions may coincide. g and hess may be null.
/// [Cirio et al. 2014, Yarn-level simulation of woven cloth, bending energy]
double bending_energy(double k_b, const Vec<11>& q, Vec<11>* g, Mat<11>* hess);

/// Bending at every visit between two segments, straight at rest; with plasticity at its set angle (plasticity.h).
class Bending {
 public:
  static constexpr int kSize = 11;
  static constexpr std::string_view kName = "bending";

  explicit Bending(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);

  /// Set angles after a step of h seconds that ended at q (num_visits); untouched without plasticity.
  void creep(double h, const VecX& q, VecX& set_angle) const;

 private:
  int visit(int k) const { return coords_[static_cast<std::size_t>(k)][3] - first_arc_coord_ + 1; }

  std::optional<PlasticityEffect> plasticity_;
  int first_arc_coord_ = 0;
  std::vector<double> set_;                     // [rad] (size); empty without plasticity
  double k_b_ = 0.0;                            // [N m^2]
  std::vector<std::array<int, kSize>> coords_;  // (size)
};
static_assert(ForceTerm<Bending>);

}  // namespace slipstitch
