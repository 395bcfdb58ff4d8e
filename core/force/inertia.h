// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// Inertia of every segment in momentum form: with M and dT/dq frozen near the solve (StepContext) and D = q - q*,
///   E(q) = 1/2 D^T M D / h^2 - D^T (p* + h dT/dq) / h,
/// so that a stationary point of the sum of all terms gives M D / h = p* + h (dT/dq + F(q)), and the momentum there is
/// M D / h. Linear momentum is exact even while yarns slide, because dT/dq sums to zero over positions. M is singular
/// along straight yarn (a node can slide without moving material), therefore every free arc length carries a small mass
/// of its own, m_u.
class Inertia {
 public:
  static constexpr int kSize = 8;
  static constexpr std::string_view kName = "inertia";

  explicit Inertia(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);

  /// M(q) v in full coordinates (num_coords); zeros where inertia is off.
  VecX momentum(const VecX& q, const VecX& v) const;
  /// 1/2 v^T M(q) v [J], the sliding mass included.
  double kinetic_energy(const VecX& q, const VecX& v) const;

 private:
  Mat<8> mass(int k, const Vec<8>& q) const;

  bool velocity_terms_ = true;

  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> density_;                 // rho / c_L [kg/m] (size)
  std::vector<std::array<double, 2>> arc_mass_;  // m_u share on u0 and u1 [kg] (size)
  std::vector<std::array<bool, 2>> owner_;      // whether this stencil carries p of its first, second visit (size x 2)
  std::vector<std::array<bool, 2>> node_owner_;  // the same for the positions (size x 2)
  double h_ = kNoStepYet;                       // [s]
  std::vector<Mat<8>> mass_;                    // M (size)
  std::vector<Vec<8>> linear_;                  // this stencil's share of p* + h dT/dq (size)
  std::vector<Vec<8>> start_;                   // q* (size)
};
static_assert(ForceTerm<Inertia>);

}  // namespace slipstitch
