// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "force/term.h"
#include "force/wrap_angle.h"
#include "force/wrap_fade.h"
#include "math/smoothstep.h"
#include "model/model.h"

namespace slipstitch {

/// The published energy V = 1/2 k (psi - rest)^2, k = k_w L [N m], singular where psi is. Order x0, x1, x3, x4.
/// [Cirio et al. 2017, Yarn-level cloth simulation with sliding persistent contacts]
double bare_wrapping_energy(double k, double rest, const Vec<12>& q, Vec<12>* g, Mat<12>* hess);

struct Wrap {
  double k = 0.0;     // k_w L [N m]
  double rest = 0.0;  // [rad]
  double L = 0.0;     // rest length of the contact [m]
};

/// The energy in use, C2 everywhere: V = k S (E(t) + offset), t = psi - rest brought into (-pi, pi],
/// S = wrap_fade, E = wrap_well. The derivatives are exact also where it fades.
double wrapping_energy(const Wrap& wrap, double offset, const Vec<12>& q, Vec<12>* g, Mat<12>* hess);

/// k S E''(t) dpsi dpsi^T, the part that is never negative.
void convex_wrapping_hessian(const Wrap& wrap, const Vec<12>& q, Mat<12>& hess);

/// t^2/2 for |t| <= pi - 0.1; from there E' = t (1 - smoothstep) falls to 0 at +-pi, so that E, periodic, is C2 there.
Jet2 wrap_well(double t);
inline constexpr double kWrapCapWidth = 0.1;

double wrap_excess(double psi, double rest);  // psi - rest in (-pi, pi]
inline bool wrap_in_cap(double t) { return t > kPi - kWrapCapWidth || t < kWrapCapWidth - kPi; }

/// A wrap that fades with offset 0 gives up its energy and so draws the yarn straight; with -pi^2/6, minus the mean
/// of t^2/2 over the circle, it does not on average. The default leaves fewer faded wraps on free swatches and rests
/// in fewer iterations.
enum class WrapFadeForm { plain, no_net_attraction };

/// Both diagonals of every stitch contact. k_w L with L the rest arc length of yarn u in the contact, the same for both
/// yarns; a diagonal without one of its outer nodes is absent.
class Wrapping {
 public:
  static constexpr int kSize = 12;
  static constexpr std::string_view kName = "wrapping";

  explicit Wrapping(const Model& model, WrapFadeForm form = WrapFadeForm::no_net_attraction);
  int size() const { return static_cast<int>(coords_.size()); }
  std::array<int, kSize> coords(int k) const { return coords_[static_cast<std::size_t>(k)]; }
  double eval(int k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const {
    const auto i = static_cast<std::size_t>(k);
    if (naive_.unsigned_angle || naive_.unfaded_wraps) [[unlikely]] return naive_energy(i, q, g, hess);
    return wrapping_energy(wraps_[i], offset_, q, g, hess);
  }
  void convex_hessian(int k, const Vec<kSize>& q, Mat<kSize>& hess) const {
    convex_wrapping_hessian(wrap(k), q, hess);
  }
  void begin_step(const StepContext&) {}

  /// Below which the sum of all energies cannot fall [J]: every wrap at rest, S = 1 and E = 0.
  double least_energy() const;

  int contact(int k) const { return contact_[static_cast<std::size_t>(k)]; }  // index of its stitch contact
  const Wrap& wrap(int k) const { return wraps_[static_cast<std::size_t>(k)]; }  // its rest angle is s psi0

 private:
  double naive_energy(std::size_t k, const Vec<kSize>& q, Vec<kSize>* g, Mat<kSize>* hess) const;

  Naive naive_;
  double offset_ = 0.0;                         // added to E(t)
  std::vector<std::array<int, kSize>> coords_;  // (size)
  std::vector<Wrap> wraps_;                     // (size)
  std::vector<int> contact_;                    // (size)
};
static_assert(ForceTerm<Wrapping>);

}  // namespace slipstitch
