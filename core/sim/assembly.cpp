// SPDX-License-Identifier: MIT
#include "sim/assembly.h"

#include <algorithm>
#include <cmath>

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
  std::vector<int> dofs;
  dofs.reserve(N);
  for (int c : coords)
    for (int e = map.first[static_cast<std::size_t>(c)]; e < map.first[static_cast<std::size_t>(c) + 1]; ++e)
      dofs.push_back(map.dof[static_cast<std::size_t>(e)]);
  std::sort(dofs.begin(), dofs.end());
  dofs.erase(std::unique(dofs.begin(), dofs.end()), dofs.end());
  return dofs;
}

template <class Term>
Vec<Term::kSize> gather(const Term& term, int k, const VecX& q) {
  Vec<Term::kSize> local;
  const auto coords = term.coords(k);
  for (std::size_t i = 0; i < coords.size(); ++i) local[static_cast<Eigen::Index>(i)] = q[coords[i]];
  return local;
}

}  // namespace

Assembly::Assembly(const YarnForces& forces, const DofMap& map, Stencils stencils) : map_(map), stencils_(stencils) {
  std::vector<std::vector<int>> cliques;
  for_each_term(forces, [&](const auto& term, int i) {
    Pool& pool = pools_[static_cast<std::size_t>(i)];
    select(term, pool);
    if constexpr (!HasChangingStencils<std::decay_t<decltype(term)>>)
      for (int k : pool.stencil) cliques.push_back(unknowns(map_, term.coords(k)));
  });
  lasting_ = pattern_ = make_pattern(map_.num_dofs, cliques);
  if (!fits(forces)) change_pattern(forces);
  for_each_term(forces, [&](const auto& term, int i) { place(term, pools_[static_cast<std::size_t>(i)]); });
}

void Assembly::refresh(const YarnForces& forces) {
  bool changed = false;
  for_each_term(forces, [&](const auto& term, int i) {
    if constexpr (HasChangingStencils<std::decay_t<decltype(term)>>) {
      Pool& pool = pools_[static_cast<std::size_t>(i)];
      if (pool.revision == term.revision() && pool.seen == term.size()) return;
      select(term, pool);
      changed = true;
    }
  });
  if (!changed) return;
  if (!fits(forces)) change_pattern(forces);
  for_each_term(forces, [&](const auto& term, int i) {
    if constexpr (HasChangingStencils<std::decay_t<decltype(term)>>) place(term, pools_[static_cast<std::size_t>(i)]);
  });
}

/// Whether the pattern has room for all stencils.
bool Assembly::fits(const YarnForces& forces) const {
  bool all = true;
  for_each_term(forces, [&](const auto& term, int i) {
    if constexpr (HasChangingStencils<std::decay_t<decltype(term)>>) {
      const Pool& pool = pools_[static_cast<std::size_t>(i)];
      for (std::size_t n = pool.placed; n < pool.stencil.size() && all; ++n)
        all = pattern_->contains(unknowns(map_, term.coords(pool.stencil[n])));
    }
  });
  return all;
}

/// Makes room for all stencils, and for none that are gone.
void Assembly::change_pattern(const YarnForces& forces) {
  std::vector<std::vector<int>> cliques;
  for_each_term(forces, [&](const auto& term, int i) {
    if constexpr (HasChangingStencils<std::decay_t<decltype(term)>>)
      for (int k : pools_[static_cast<std::size_t>(i)].stencil) cliques.push_back(unknowns(map_, term.coords(k)));
  });
  const auto before = pattern_;
  pattern_ = with_cliques(*lasting_, cliques);
  const std::vector<int> moved = slots_in(*before, *pattern_);
  for (Pool& pool : pools_)
    for (int& slot : pool.slots)
      if (slot >= 0) slot = moved[static_cast<std::size_t>(slot)];
}

/// Takes in the stencils that the term has added, or all if it has changed others.
template <class Term>
void Assembly::select(const Term& term, Pool& pool) const {
  if constexpr (HasChangingStencils<Term>) {
    if (pool.revision != term.revision()) {
      pool.seen = 0;
      pool.placed = 0;
      pool.stencil.clear();
      pool.dofs.clear();
      pool.slots.clear();
    }
    pool.revision = term.revision();
  }
  for (; pool.seen < term.size(); ++pool.seen)
    if (stencils_ == Stencils::all || !unknowns(map_, term.coords(pool.seen)).empty())
      pool.stencil.push_back(pool.seen);
  if constexpr (HasStress<Term>) pool.stress.assign(pool.stencil.size(), 0.0);
}

template <class Term>
void Assembly::place(const Term& term, Pool& pool) const {
  if (!map_.simple) return;
  pool.dofs.reserve(pool.stencil.size() * Term::kSize);
  pool.slots.reserve(pool.stencil.size() * Term::kSize * (Term::kSize + 1) / 2);
  for (; pool.placed < pool.stencil.size(); ++pool.placed) {
    std::array<int, Term::kSize> dofs;
    const auto coords = term.coords(pool.stencil[pool.placed]);
    for (std::size_t i = 0; i < Term::kSize; ++i) dofs[i] = map_.dof_of(coords[i]);
    pool.dofs.insert(pool.dofs.end(), dofs.begin(), dofs.end());
    for (std::size_t c = 0; c < Term::kSize; ++c)
      for (std::size_t r = c; r < Term::kSize; ++r)
        pool.slots.push_back(dofs[r] < 0 || dofs[c] < 0
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

namespace {

/// Energy and gradient of stencil k, and its Hessian in the asked mode.
template <class Term>
double eval_in_mode(const Term& term, int k, HessianMode mode, const double* stress, const Vec<Term::kSize>& q,
                    Vec<Term::kSize>& g, Mat<Term::kSize>& hess) {
  if constexpr (HasStress<Term>) {
    if (mode == HessianMode::predicted) {
      const double e = term.eval(k, q, &g, nullptr);
      term.hessian_at(k, q, *stress, hess);
      return e;
    }
  }
  if constexpr (HasConvexHessian<Term>) {
    if (mode == HessianMode::convex) {
      const double e = term.eval(k, q, &g, nullptr);
      term.convex_hessian(k, q, hess);
      return e;
    }
  }
  return term.eval(k, q, &g, &hess);
}

}  // namespace

template <class Term>
void Assembly::add(const Term& term, Pool& pool, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h,
                   double& energy) {
  constexpr int kSize = Term::kSize;
  Vec<kSize> gl;
  Mat<kSize> hl;
  const int* dof = pool.dofs.data();
  const int* slot = pool.slots.data();
  const double* stress = pool.stress.data();
  pool.evaluations += static_cast<long>(pool.stencil.size());
  for (int k : pool.stencil) {
    const double e = eval_in_mode(term, k, mode, stress, gather(term, k, q), gl, hl);
    if constexpr (HasStress<Term>) ++stress;
    energy += e;
    scale_ += std::abs(e);
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

void Assembly::predict(const YarnForces& forces, const VecX& q, const VecX& dq) {
  refresh(forces);
  for_each_term(forces, [&](const auto& term, int i) {
    if constexpr (HasStress<std::decay_t<decltype(term)>>) {
      Pool& pool = pools_[static_cast<std::size_t>(i)];
      for (std::size_t n = 0; n < pool.stencil.size(); ++n) {
        const int k = pool.stencil[n];
        pool.stress[n] = term.stress(k, gather(term, k, q), gather(term, k, dq));
      }
    }
  });
}

double Assembly::derivatives(const YarnForces& forces, const VecX& q, HessianMode mode, VecX& g, SparseMatrix& h) {
  refresh(forces);
  g.setZero(map_.num_dofs);
  h.pattern = pattern_;
  h.values.assign(pattern_->row.size(), 0.0);
  scale_ = 0.0;
  energies_.fill(0.0);
  for_each_term(forces, [&](const auto& term, int i) {
    const auto t = static_cast<std::size_t>(i);
    add(term, pools_[t], q, mode, g, h, energies_[t]);
  });
  double sum = 0.0;
  for (double e : energies_) sum += e;
  return sum;
}

double Assembly::value(const YarnForces& forces, const VecX& q) {
  refresh(forces);
  scale_ = 0.0;
  energies_.fill(0.0);
  for_each_term(forces, [&](const auto& term, int i) {
    double& energy = energies_[static_cast<std::size_t>(i)];
    Pool& pool = pools_[static_cast<std::size_t>(i)];
    pool.evaluations += static_cast<long>(pool.stencil.size());
    for (int k : pool.stencil) {
      const double e = term.eval(k, gather(term, k, q), nullptr, nullptr);
      energy += e;
      scale_ += std::abs(e);
    }
  });
  double sum = 0.0;
  for (double e : energies_) sum += e;
  return sum;
}

long Assembly::count_entries(const Pool& pool) const {
  std::vector<char> entered(pattern_->row.size(), 0);
  for (int slot : pool.slots)
    if (slot >= 0) entered[static_cast<std::size_t>(slot)] = 1;
  return std::count(entered.begin(), entered.end(), 1);
}

EffectCosts Assembly::costs(const YarnForces& forces) const {
  EffectCosts costs;
  for_each_term(forces, [&](const auto& term, int i) {
    const Pool& pool = pools_[static_cast<std::size_t>(i)];
    if (pool.stencil.empty() && pool.evaluations == 0) return;
    EffectCost& cost = costs[std::string(std::decay_t<decltype(term)>::kName)];
    cost.stencils = static_cast<long>(pool.stencil.size());
    cost.bytes = static_cast<long>((pool.stencil.size() + pool.dofs.size() + pool.slots.size()) * sizeof(int) +
                                   pool.stress.size() * sizeof(double));
    cost.nonzeros = count_entries(pool);
    cost.evaluations = pool.evaluations;
  });
  return costs;
}

}  // namespace slipstitch
