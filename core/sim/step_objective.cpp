// SPDX-License-Identifier: MIT
#include "sim/step_objective.h"

#include <cmath>

namespace slipstitch {
namespace {

constexpr double kKeepArc = 0.1;            // least share of a segment's arc length left by one Newton step
constexpr double kLargestTurn = kPi / 4.0;  // of a wrap in one Newton step
constexpr int kMaxTurnHalvings = 8;

Vec<12> gather(const std::array<int, 12>& coords, const VecX& q) {
  Vec<12> x;
  for (int i = 0; i < 12; ++i) x[i] = q[coords[static_cast<std::size_t>(i)]];
  return x;
}

double angle(const Vec<12>& x) {
  return wrap_angle(x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x.segment<3>(9));
}

double fade(const Vec<12>& x) { return wrap_fade_derivatives(x, nullptr, nullptr); }

}  // namespace

double StepObjective::value(const VecX& y) {
  const Stopwatch watch(wall_["energy"]);
  expand(map_, y, q_);
  return assembly_.value(forces_, q_);
}

double StepObjective::derivatives(const VecX& y, HessianMode mode, VecX& g, SparseMatrix& h) {
  const Stopwatch watch(wall_["assembly"]);
  expand(map_, y, q_);
  return assembly_.derivatives(forces_, q_, mode, g, h);
}

double StepObjective::max_step(const VecX& y, const VecX& dy) {
  const Stopwatch watch(wall_["step_limits"]);
  expand(map_, y, q_);
  expand(map_, y + dy, dq_);
  dq_ -= q_;
  double a = order_preserving_step(topology_, q_, dq_, kKeepArc);
  for (int k = 0; k < kMaxTurnHalvings && turns_too_far(q_, dq_, a); ++k) a *= 0.5;
  return a;
}

bool StepObjective::turns_too_far(const VecX& q, const VecX& dq, double a) const {
  const auto& wraps = std::get<Wrapping>(forces_);
  for (int k = 0; k < wraps.size(); ++k) {
    const auto coords = wraps.coords(k);
    const Vec<12> x = gather(coords, q), moved = x + a * gather(coords, dq);
    if (std::abs(wrap_excess(angle(moved), angle(x))) <= kLargestTurn) continue;
    if (fade(x) > 0.0 && fade(moved) > 0.0) return true;  // along the axis psi means nothing
  }
  return false;
}

void StepObjective::extrapolate(VecX& y, double h, const VecX& v) {
  VecX guess = y;
  for (int c = 0; c < map_.num_coords(); ++c)
    if (const int d = map_.dof_of(c); d >= 0) guess[d] += h * v[c];
  guess = y + max_step(y, guess - y) * (guess - y);
  if (std::isfinite(value(guess))) y = guess;
}

}  // namespace slipstitch
