// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// V = -rho D g.(x0 + x1)/2 of one segment, D = u1 - u0; rho [kg/m], acceleration g [m/s^2]. Order x0, u0, x1, u1.
double gravity_energy(double rho, const Vec3& acceleration, const Vec<8>& q, Vec<8>* g, Mat<8>* hess);

/// Weight of every segment.
class Gravity {
 public:
  static constexpr int kSize = 8;
  static constexpr std::string_view kName = "gravity";

  explicit Gravity(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    return gravity_energy(rho_[static_cast<std::size_t>(k)], acceleration_, q, g, hess);
  }
  void convex_hessian(int, const Vec<kSize>&, Mat<kSize>& hess) const { hess.setZero(); }
  void begin_step(const StepContext&) {}

 private:
  Vec3 acceleration_ = Vec3::Zero();
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> rho_;                     // [kg/m] (size)
};
static_assert(ForceTerm<Gravity>);

}  // namespace slipstitch
