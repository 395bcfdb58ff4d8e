// SPDX-License-Identifier: MIT
#pragma once

#include "solve/sparse_pattern.h"

namespace slipstitch {

/// Which second derivatives. With V = f(s(x)) a term's energy and its stress f', the exact Hessian is
/// f'' ds ds^T + f' dds.
enum class HessianMode {
  predicted,  // f' as `predict` foresaw it, where a term offers that; elsewhere exact
  exact,
  convex  // positive semidefinite: the exact one without what can be negative
};

/// A smooth function of n unknowns with a sparse Hessian.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual double value(const VecX& x) = 0;
  /// Returns the value; fills g (n) and the values of h on its pattern.
  virtual double derivatives(const VecX& x, HessianMode mode, VecX& g, SparseMatrix& h) = 0;
  /// Largest a in (0, 1] such that x + a dx keeps what must never be broken.
  virtual double max_step(const VecX& x, const VecX& dx) = 0;
  /// Magnitude of the terms summed in value(): its round-off is about 1e-16 times this.
  virtual double value_scale() const = 0;

  /// The search moves from x by dx: the stresses to use next are those the linearisation at x promises at x + dx.
  virtual void predict(const VecX& x, const VecX& dx);
  /// Minimises over those unknowns that few others touch, the rest held, starting from x or from `before`, whichever is
  /// lower. Never raises the value.
  virtual void settle(VecX& x, const VecX& before);
  /// max |dx| over the unknowns that `settle` leaves alone, and of the last step inside `settle`.
  virtual double step_size(const VecX& dx) const;
};

}  // namespace slipstitch
