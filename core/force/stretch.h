// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// V = 1/2 k_s D (|d|/D - 1)^2 of one segment, D = u1 - u0, d = x1 - x0. Order x0, u0, x1, u1.
/// D <= 0 has no meaning: the energy is infinite and the derivatives are 0. g and hess may be null.
/// [Cirio et al. 2014, Yarn-level simulation of woven cloth, stretch energy]
double stretch_energy(double k_s, const Vec<8>& q, Vec<8>* g, Mat<8>* hess);

/// Share of its length to which yarn must be pressed to be crushed.
inline constexpr double kCrushed = 0.05;

/// Stretching of every segment, measured against length_factor() times its arc length (shrinkage.h). That lets forces
/// press a segment to a point, where it has no direction and angles have no derivatives. So V has, besides,
///   k_s D log_barrier(lambda/kCrushed),  lambda = |d|/D,
/// which changes nothing from kCrushed on.
class Stretch {
 public:
  static constexpr int kSize = 8;
  static constexpr std::string_view kName = "stretch";

  explicit Stretch(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);
  /// Tension k_s (|d|/D - 1) [N], extrapolated.
  double stress(int k, const Vec<kSize>& q, const Vec<kSize>& dq) const;
  void hessian_at(int k, const Vec<kSize>& q, double tension, Mat<kSize>& hess) const;
  /// Without the geometric stiffness of a segment under compression.
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  /// Rest length over arc length at the end of the step; 1 without shrinkage.
  double length_factor() const { return factor_; }

 private:
  const Model* model_ = nullptr;                // outlives the pool
  double factor_ = 1.0;
  double k_s_ = 0.0;                            // [N]
  std::vector<std::array<int, kSize>> coords_;  // (size)
};
static_assert(ForceTerm<Stretch>);

}  // namespace slipstitch
