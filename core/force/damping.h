// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

// Viscous damping of internal rates: each term adds h * 1/2 eta rate^2 to the step's potential, the rate taken as the
// change of its measure over the step divided by h (StepContext). The measures do not change in rigid motion, which is therefore
// undamped.

/// Rate of the stretch lambda = |d|/D, weighted by the segment's rest length: 1/2 eta D_rest ((lambda - lambda*)/h)^2 h.
class DampingStretch {
 public:
  static constexpr int kSize = 8;
  static constexpr std::string_view kName = "damping_stretch";

  explicit DampingStretch(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);

 private:
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> eta_length_;              // eta D_rest [N s m] (size)
  std::vector<double> start_;                   // lambda* (size)
  double h_ = kNoStepYet;
};
static_assert(ForceTerm<DampingStretch>);

/// Rate of the bend angle, eta thetadot^2 / W_rest (the viscous twin of k_b theta^2 / W). Theta has a cone at 0;
/// sqrt(theta^2 + kSmoothing^2) stands for it, so that nearly straight yarn is damped less.
class DampingBending {
 public:
  static constexpr int kSize = 11;
  static constexpr std::string_view kName = "damping_bending";
  static constexpr double kSmoothing = 0.5;  // [rad]

  explicit DampingBending(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);

 private:
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> eta_by_length_;           // eta / W_rest [N m s] (size)
  std::vector<double> start_;                   // measure* (size)
  double h_ = kNoStepYet;
};
static_assert(ForceTerm<DampingBending>);

/// Rate of the wrap angle, 1/2 eta L psidot^2 faded like the wrap itself.
class DampingWrapping {
 public:
  static constexpr int kSize = 12;
  static constexpr std::string_view kName = "damping_wrapping";

  explicit DampingWrapping(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const;
  void begin_step(const StepContext& step);

 private:
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> eta_length_, length_;     // eta L [N m s], L [m] (size)
  std::vector<double> start_;                   // psi* (size)
  double h_ = kNoStepYet;
};
static_assert(ForceTerm<DampingWrapping>);

/// 1/2 d_f udot^2 on every sliding coordinate.
class DampingSliding {
 public:
  static constexpr int kSize = 1;
  static constexpr std::string_view kName = "damping_sliding";

  explicit DampingSliding(const Model& model);
  int size() const { return static_cast<int>(coord_.size()); }
  std::array<int, kSize> coords(int k) const { return {coord_[static_cast<std::size_t>(k)]}; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;
  void begin_step(const StepContext& step);

 private:
  double d_f_ = 0.0;         // [N s/m]
  std::vector<int> coord_;   // (size)
  std::vector<double> start_;  // u* [m] (size)
  double h_ = kNoStepYet;
};
static_assert(ForceTerm<DampingSliding>);

}  // namespace slipstitch
