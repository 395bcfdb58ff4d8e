// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

struct JammingParameters {
  double k_b = 0.0;             // [N m^2]
  double log_max_factor = 0.0;  // >= 0
  double full_at = 2.0;         // curvature ratio of the full factor > 1
};

/// V = (f - 1) k_b theta^2/W: what bending gains where k_b grows to f k_b. f = exp(log_max_factor S(s)), S the C2
/// smoothstep of s = (kappa/kappa_j - 1)/(full_at - 1), kappa = 2 theta/W, kappa_j [1/m]. Order as bending_energy.
/// Exactly 0 while kappa <= kappa_j.
double bending_jamming_energy(const JammingParameters& p, double kappa_j, const Vec<11>& q, Vec<11>* g, Mat<11>* hess);

/// Stiffening of sharp bends, at every visit that bends; kappa_j = pi/W_rest, a right angle at rest arc length.
class BendingJamming {
 public:
  static constexpr int kSize = 11;
  static constexpr std::string_view kName = "bending_jamming";

  explicit BendingJamming(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    return bending_jamming_energy(parameters_, kappa_j_[static_cast<std::size_t>(k)], q, g, hess);
  }
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext&) {}

 private:
  JammingParameters parameters_;
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> kappa_j_;                 // [1/m] (size)
};
static_assert(ForceTerm<BendingJamming>);

}  // namespace slipstitch
