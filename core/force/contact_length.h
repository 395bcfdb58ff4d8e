// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// V = 1/2 k_l L (D/L - 1)^2, D = u1 - u0; k_l [N], L rest arc length [m]. Order u0, u1.
double contact_length_energy(double k_l, double L, const Vec<2>& q, Vec<2>* g, Mat<2>* hess);

/// Keeps the arc length of both yarns inside every stitch contact, so that no yarn is created or lost where one end of
/// the contact slides.
class ContactLength {
 public:
  static constexpr int kSize = 2;
  static constexpr std::string_view kName = "contact_length";

  explicit ContactLength(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    return contact_length_energy(k_l_, rest_[static_cast<std::size_t>(k)], q, g, hess);
  }
  void begin_step(const StepContext&) {}

 private:
  double k_l_ = 0.0;                            // [N]
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> rest_;                    // L [m] (size)
};
static_assert(ForceTerm<ContactLength>);

}  // namespace slipstitch
