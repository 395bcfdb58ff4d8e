// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "force/yarn_forces.h"
#include "sim/dof_map.h"
#include "sim/effect_cost.h"
#include "solve/objective.h"

namespace slipstitch {

enum class Stencils { all, touching };  // touching: only those that an unknown of the map enters

/// Sums the energies of all force terms, their gradients and Hessians, in the unknowns of a DofMap.
/// The sparsity pattern and each stencil's places in it are kept; stencils that terms add or drop are taken in at the next
/// evaluation, and the pattern changes only where one does not fit into it.
class Assembly {
 public:
  Assembly(const YarnForces& forces, const DofMap& map, Stencils stencils = Stencils::all);

  double value(const YarnForces& forces, const VecX& q);
  /// g (num_dofs) and h in the unknowns; returns the value.
  double derivatives(const YarnForces& forces, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h);

  /// Stresses for HessianMode::predicted: those that the linearisation at q promises at q + dq. 0 before the first call.
  void predict(const YarnForces& forces, const VecX& q, const VecX& dq);

  const std::shared_ptr<const SparsePattern>& pattern() const { return pattern_; }
  double scale() const { return scale_; }  // sum of |stencil energies| of the last value or derivatives
  /// Energy of each term at the last value or derivatives, in the order of YarnForces.
  const std::array<double, kNumTerms>& energies() const { return energies_; }
  /// What the terms that have or had stencils here took so far; entries are counted in simple maps only.
  EffectCosts costs(const YarnForces& forces) const;

 private:
  struct Pool {                 // the stencils in use of one term
    std::vector<int> stencil;   // (n)
    std::vector<double> stress;  // predicted (n); empty if the term has none
    std::vector<int> dofs;      // unknown of each local coordinate, -1: held (n x kSize); simple maps only
    long revision = 0;
    int seen = 0;               // stencils of the term that were looked at
    std::size_t placed = 0;     // stencils that have dofs and slots; simple maps only
    std::vector<int> slots;     // place of each lower-triangle pair, -1: none (n x kSize (kSize+1)/2); simple maps only
    long evaluations = 0;       // of one stencil
  };
  template <class Term>
  void select(const Term& term, Pool& pool) const;
  void refresh(const YarnForces& forces);
  bool fits(const YarnForces& forces) const;
  void change_pattern(const YarnForces& forces);
  template <class Term>
  void place(const Term& term, Pool& pool) const;
  template <class Term>
  void add(const Term& term, Pool& pool, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h,
           double& energy);
  long count_entries(const Pool& pool) const;
  template <class Term>
  void scatter_general(const Term& term, int k, const Vec<Term::kSize>& gl, const Mat<Term::kSize>& hl, VecX& g,
                       SparseMatrix& h) const;

  DofMap map_;
  Stencils stencils_;
  std::shared_ptr<const SparsePattern> lasting_;  // of the terms whose stencils never change
  std::shared_ptr<const SparsePattern> pattern_;
  std::array<Pool, kNumTerms> pools_;
  std::array<double, kNumTerms> energies_{};
  double scale_ = 0.0;
};

/// Gradient of one term in full coordinates, added to `gradient` (num_coords). Only the stencils that touch a coordinate
/// `wanted` (num_coords) are evaluated; an empty one wants all.
template <class Term>
void add_full_gradient(const Term& term, const VecX& q, const std::vector<char>& wanted, VecX& gradient) {
  Vec<Term::kSize> ql, gl;
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    const auto asked = [&](int c) { return wanted[static_cast<std::size_t>(c)] != 0; };
    if (!wanted.empty() && std::none_of(coords.begin(), coords.end(), asked)) continue;
    for (int i = 0; i < Term::kSize; ++i) ql[i] = q[coords[static_cast<std::size_t>(i)]];
    term.eval(k, ql, &gl, nullptr);
    for (int i = 0; i < Term::kSize; ++i) gradient[coords[static_cast<std::size_t>(i)]] += gl[i];
  }
}

}  // namespace slipstitch
