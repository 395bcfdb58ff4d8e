// SPDX-License-Identifier: MIT
#include "sim/assembly.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace slipstitch {
namespace {

template <class F>
void for_each_term(const YarnForces& forces, F&& f) {
  std::apply([&](const auto&... term) {
    int index = 0;
    (f(term, index++), ...);
  }, forces);
}

/// Unknowns touched by stencil coordinates, ascending, without repeats.
template <std::size_t N>
std::vector<int> unknowns(const DofMap& map, const std::array<int, N>& coords) {
  std::set<int> dofs;
  for (int c : coords)
    for (int e = map.first[static_cast<std::size_t>(c)]; e < map.first[static_cast<std::size_t>(c) + 1]; ++e)
      dofs.insert(map.dof[static_cast<std::size_t>(e)]);
  return {dofs.begin(), dofs.end()};
}

}  // namespace

Assembly::Assembly(const YarnForces& forces, const DofMap& map) : map_(map) {
  std::vector<std::vector<int>> cliques;
  for_each_term(forces, [&](const auto& term, int) {
    for (int k = 0; k < term.size(); ++k) cliques.push_back(unknowns(map_, term.coords(k)));
  });
  pattern_ = make_pattern(map_.num_dofs, cliques);
  if (!map_.simple) return;
  for_each_term(forces, [&](const auto& term, int i) { place(term, stencils_[static_cast<std::size_t>(i)]); });
}

template <class Term>
void Assembly::place(const Term& term, Stencils& stencils) const {
  stencils.dofs.reserve(static_cast<std::size_t>(term.size()) * Term::kSize);
  stencils.slots.reserve(static_cast<std::size_t>(term.size()) * Term::kSize * (Term::kSize + 1) / 2);
  for (int k = 0; k < term.size(); ++k) {
    std::array<int, Term::kSize> dofs;
    const auto coords = term.coords(k);
    for (std::size_t i = 0; i < Term::kSize; ++i) dofs[i] = map_.dof_of(coords[i]);
    stencils.dofs.insert(stencils.dofs.end(), dofs.begin(), dofs.end());
    for (std::size_t c = 0; c < Term::kSize; ++c)
      for (std::size_t r = c; r < Term::kSize; ++r)
        stencils.slots.push_back(dofs[r] < 0 || dofs[c] < 0
                                     ? -1
                                     : pattern_->slot(std::max(dofs[r], dofs[c]), std::min(dofs[r], dofs[c])));
  }
}

template <class Term>
void Assembly::scatter_general(const Term& term, int k, const Vec<Term::kSize>& gl, const Mat<Term::kSize>& hl, VecX& g,
                               SparseMatrix& h) const {
  const auto coords = term.coords(k);
  const std::vector<int> dofs = unknowns(map_, coords);
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(Term::kSize, static_cast<Eigen::Index>(dofs.size()));
  for (int i = 0; i < Term::kSize; ++i) {
    const auto c = static_cast<std::size_t>(coords[static_cast<std::size_t>(i)]);
    for (int e = map_.first[c]; e < map_.first[c + 1]; ++e) {
      const auto it = std::lower_bound(dofs.begin(), dofs.end(), map_.dof[static_cast<std::size_t>(e)]);
      w(i, it - dofs.begin()) += map_.weight[static_cast<std::size_t>(e)];
    }
  }
  const Eigen::VectorXd gy = w.transpose() * gl;
  const Eigen::MatrixXd hy = w.transpose() * hl * w;
  for (std::size_t c = 0; c < dofs.size(); ++c) {
    g[dofs[c]] += gy[static_cast<Eigen::Index>(c)];
    for (std::size_t r = c; r < dofs.size(); ++r)
      h.values[static_cast<std::size_t>(pattern_->slot(dofs[r], dofs[c]))] +=
          hy(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
  }
}

template <class Term>
void Assembly::add(const Term& term, const Stencils& stencils, const VecX& q, HessianMode mode, VecX& g,
                   SparseMatrix& h, double& energy) {
  constexpr int kSize = Term::kSize;
  Vec<kSize> ql, gl;
  Mat<kSize> hl;
  const int* dof = stencils.dofs.data();
  const int* slot = stencils.slots.data();
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    for (int i = 0; i < kSize; ++i) ql[i] = q[coords[static_cast<std::size_t>(i)]];
    const double e = term.eval(k, ql, &gl, &hl);
    energy += e;
    scale_ += std::abs(e);
    if constexpr (requires { term.convexify(k, ql, hl); }) {
      if (mode == HessianMode::convexified) term.convexify(k, ql, hl);
    }
    if (!map_.simple) {
      scatter_general(term, k, gl, hl, g, h);
      continue;
    }
    for (int c = 0; c < kSize; ++c) {
      if (dof[c] >= 0) g[dof[c]] += gl[c];
      for (int r = c; r < kSize; ++r, ++slot)
        if (*slot >= 0) h.values[static_cast<std::size_t>(*slot)] += hl(r, c);
    }
    dof += kSize;
  }
}

double Assembly::derivatives(const YarnForces& forces, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h) {
  g.setZero(map_.num_dofs);
  h.pattern = pattern_;
  h.values.assign(pattern_->row.size(), 0.0);
  scale_ = 0.0;
  energies_.fill(0.0);
  for_each_term(forces, [&](const auto& term, int i) {
    const auto t = static_cast<std::size_t>(i);
    add(term, stencils_[t], q, mode, g, h, energies_[t]);
  });
  double sum = 0.0;
  for (double e : energies_) sum += e;
  return sum;
}

double Assembly::value(const YarnForces& forces, const VecX& q) {
  scale_ = 0.0;
  energies_.fill(0.0);
  for_each_term(forces, [&](const auto& term, int i) {
    using Term = std::decay_t<decltype(term)>;
    double& energy = energies_[static_cast<std::size_t>(i)];
    Vec<Term::kSize> ql;
    for (int k = 0; k < term.size(); ++k) {
      const auto coords = term.coords(k);
      for (int j = 0; j < Term::kSize; ++j) ql[j] = q[coords[static_cast<std::size_t>(j)]];
      const double e = term.eval(k, ql, nullptr, nullptr);
      energy += e;
      scale_ += std::abs(e);
    }
  });
  double sum = 0.0;
  for (double e : energies_) sum += e;
  return sum;
}

}  // namespace slipstitch
