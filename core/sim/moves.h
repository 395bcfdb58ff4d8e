// SPDX-License-Identifier: MIT
#pragma once

#include "force/yarn_forces.h"

namespace slipstitch {

/// Largest share <= a of the way from q to q + dq (full coordinates) that every term allows. Terms may take in stencils
/// for the way, which carry no energy at q.
inline double allowed_move(YarnForces& forces, const VecX& q, const VecX& dq, double a) {
  const auto limit = [&](auto& term) {
    if constexpr (WatchesMoves<std::decay_t<decltype(term)>>) term.watch(q, a * dq);
    if constexpr (LimitsMoves<std::decay_t<decltype(term)>>) a = term.max_step(q, dq, a);
  };
  std::apply([&](auto&... term) { (limit(term), ...); }, forces);
  return a;
}

/// Moves q out of what scripted bodies have moved over.
inline void push_out(const YarnForces& forces, VecX& q) {
  const auto push = [&](const auto& term) {
    if constexpr (PushesOut<std::decay_t<decltype(term)>>) term.push_out(q);
  };
  std::apply([&](const auto&... term) { (push(term), ...); }, forces);
}

}  // namespace slipstitch
