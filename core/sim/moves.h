// SPDX-License-Identifier: MIT
#pragma once

#include "force/yarn_forces.h"

namespace slipstitch {

/// Largest share <= a of the way from q to q + dq (full coordinates) that every term allows. Terms may take in stencils
/// for the way, which carry no energy at q.
inline double allowed_move(YarnForces& forces, const VecX& q, const VecX& dq, double a) {
  const auto limit = [&](auto& term) {
    if constexpr (WatchesMoves<std::decay_t<decltype(term)>>) term.watch(q, dq, a);
    if constexpr (LimitsMoves<std::decay_t<decltype(term)>>) a = term.max_step(q, dq, a);
  };
  std::apply([&](auto&... term) { (limit(term), ...); }, forces);
  return a;
}

/// Whether a step that ends at q has outgrown what a term watches.
inline bool outgrown(const YarnForces& forces, const VecX& q) {
  const auto grown = [&](const auto& term) {
    if constexpr (CanBeOutgrown<std::decay_t<decltype(term)>>) return term.outgrown(q);
    return false;
  };
  return std::apply([&](const auto&... term) { return (grown(term) || ...); }, forces);
}

/// Moves q, to which scripts have taken it from q0, out of what they have moved over.
inline void push_out(YarnForces& forces, const VecX& q0, VecX& q) {
  const auto push = [&](auto& term) {
    if constexpr (PushesOut<std::decay_t<decltype(term)>>) term.push_out(q0, q);
  };
  std::apply([&](auto&... term) { (push(term), ...); }, forces);
}

/// Whether a term that can tell saw something pass something else on the straight way from q0 to q.
inline bool passes(YarnForces& forces, const VecX& q0, const VecX& q) {
  const auto seen = [&](auto& term) {
    if constexpr (SeesPassing<std::decay_t<decltype(term)>>) return term.passes(q0, q);
    return false;
  };
  return std::apply([&](auto&... term) { return (seen(term) || ...); }, forces);
}

}  // namespace slipstitch
