// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "model/model.h"

namespace slipstitch {

/// V = 1/2 k_c L (D - d)^2 where D = u1 - u0 < d, else 0; k_c [N/m^2], L rest arc length [m]. Order u0, u1.
/// C1: the Hessian jumps at D = d.
double parallel_contact_energy(double k_c, double L, double d, const Vec<2>& q, Vec<2>* g, Mat<2>* hess);

/// V = -k_c L d^2 (D/b - 1)^2 ln(D/b) where D < b = d/2, else 0; infinite at D <= 0. C2. The energy above gives way at
/// a tension of k_c L d, 1.3 N in the head of a stitch of the demo yarn; two contacts are never in one place, whatever
/// pulls.
double parallel_contact_barrier(double k_c, double L, double d, const Vec<2>& q, Vec<2>* g, Mat<2>* hess);

/// Keeps neighbouring contacts of one yarn apart: free segments between a contact or guide and the next node of the
/// yarn, but not the yarn's end, which can slip out.
class ParallelContact {
 public:
  static constexpr int kSize = 2;
  static constexpr std::string_view kName = "parallel_contact";

  explicit ParallelContact(const Model& model);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    const auto i = static_cast<std::size_t>(k);
    double v = parallel_contact_energy(k_c_, rest_[i], distance_[i], q, g, hess);
    if (q[1] - q[0] < 0.5 * distance_[i]) v += add_barrier(i, q, g, hess);
    return v;
  }
  void begin_step(const StepContext&) {}

 private:
  double add_barrier(std::size_t i, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;

  double k_c_ = 0.0;                            // [N/m^2]
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<double> rest_, distance_;         // L, d [m] (size)
};
static_assert(ForceTerm<ParallelContact>);

}  // namespace slipstitch
