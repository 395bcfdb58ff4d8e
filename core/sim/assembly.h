// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "force/yarn_forces.h"
#include "sim/dof_map.h"
#include "solve/newton.h"

namespace slipstitch {

/// Sums the energies of all force terms, their gradients and Hessians, in the unknowns of a DofMap.
/// The sparsity pattern and each stencil's places in it are found once.
class Assembly {
 public:
  Assembly(const YarnForces& forces, const DofMap& map);

  double value(const YarnForces& forces, const VecX& q);
  /// g (num_dofs) and h in the unknowns; returns the value.
  double derivatives(const YarnForces& forces, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h);

  const std::shared_ptr<const SparsePattern>& pattern() const { return pattern_; }
  double scale() const { return scale_; }  // sum of |stencil energies| of the last value or derivatives
  /// Energy of each term at the last value or derivatives, in the order of YarnForces.
  const std::array<double, kNumTerms>& energies() const { return energies_; }

 private:
  struct Stencils {             // of one term
    std::vector<int> dofs;      // unknown of each local coordinate, -1: held (size x kSize); simple maps only
    std::vector<int> slots;     // place of each lower-triangle pair, -1: none (size x kSize (kSize+1)/2); simple maps only
  };
  template <class Term>
  void place(const Term& term, Stencils& stencils) const;
  template <class Term>
  void add(const Term& term, const Stencils& stencils, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h,
           double& energy);
  template <class Term>
  void scatter_general(const Term& term, int k, const Vec<Term::kSize>& gl, const Mat<Term::kSize>& hl, VecX& g,
                       SparseMatrix& h) const;

  DofMap map_;
  std::shared_ptr<const SparsePattern> pattern_;
  std::array<Stencils, kNumTerms> stencils_;
  std::array<double, kNumTerms> energies_{};
  double scale_ = 0.0;
};

/// Gradient of one term in full coordinates, added to `gradient` (num_coords).
template <class Term>
void add_full_gradient(const Term& term, const VecX& q, VecX& gradient) {
  Vec<Term::kSize> ql, gl;
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    for (int i = 0; i < Term::kSize; ++i) ql[i] = q[coords[static_cast<std::size_t>(i)]];
    term.eval(k, ql, &gl, nullptr);
    for (int i = 0; i < Term::kSize; ++i) gradient[coords[static_cast<std::size_t>(i)]] += gl[i];
  }
}

}  // namespace slipstitch
