// SPDX-License-Identifier: MIT
#include "sim/step_objective.h"

#include <algorithm>
#include <cmath>

#include "force/stretch.h"
#include "force/wrapping.h"
#include "sim/moves.h"

namespace slipstitch {
namespace {

constexpr double kKeepArc = 0.1;            // least share of a segment's arc length left by one Newton step
constexpr double kLeastArc = 1e-3;          // of a segment's rest length, after any step
constexpr double kLargestTurn = kPi / 4.0;  // of a wrap in one Newton step
constexpr int kMaxTurnHalvings = 8;
constexpr double kLargestMove = 0.7;         // of one end of a segment against the other in one Newton step, in its length
constexpr double kLargestGuessStrain = 0.05;  // of a segment in the extrapolated start
constexpr int kMaxGuessHalvings = 4;

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

void StepObjective::settle_on_their_own(LooseEnds& ends, double step_tolerance) {
  ends_ = &ends;
  ends_tolerance_ = step_tolerance;
}

void StepObjective::keep_arcs(const VecX& q, double share) {
  arc_floor_.assign(static_cast<std::size_t>(topology_.num_visits()), 0.0);
  for (int i = 0; i + 1 < topology_.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology_.segment_kind[v] == SegmentKind::none) continue;
    const int u0 = topology_.arc_coord(i);
    const double arc = q[u0 + 1] - q[u0];
    arc_floor_[v] = std::max(share * arc, std::min(kLeastArc * rest_length(topology_, i), 0.5 * arc));
  }
}

double StepObjective::keep_floor(const VecX& q, const VecX& dq, double a) const {
  for (std::size_t v = 0; v + 1 < arc_floor_.size(); ++v) {
    if (!(arc_floor_[v] > 0.0)) continue;
    const int u0 = topology_.arc_coord(static_cast<int>(v));
    const double above = q[u0 + 1] - q[u0] - arc_floor_[v], change = dq[u0 + 1] - dq[u0];
    if (above + a * change < 0.0) a = std::max(0.0, 0.9 * above / -change);
  }
  return a;
}

void StepObjective::predict(const VecX& y, const VecX& dy) {
  const Stopwatch watch(wall_["energy"]);
  expand(map_, y, q_);
  expand(map_, y + dy, dq_);
  dq_ -= q_;
  assembly_.predict(forces_, q_, dq_);
}

void StepObjective::settle(VecX& y, const VecX& before) {
  if (ends_ == nullptr) return;
  const Stopwatch watch(wall_["loose_ends"]);
  expand(map_, y, q_);
  expand(map_, before, dq_);
  ends_step_ = ends_->settle(forces_, q_, dq_, ends_tolerance_);
  for (int c : ends_->coords()) y[map_.dof_of(c)] = q_[c];
}

double StepObjective::step_size(const VecX& dy) const {
  if (ends_ == nullptr) return Objective::step_size(dy);
  VecX others = dy;
  for (int c : ends_->coords()) others[map_.dof_of(c)] = 0.0;
  return std::max(ends_step_, Objective::step_size(others));
}

double StepObjective::max_step(const VecX& y, const VecX& dy) {
  const Stopwatch watch(wall_["step_limits"]);
  expand(map_, y, q_);
  expand(map_, y + dy, dq_);
  dq_ -= q_;
  double a = keep_floor(q_, dq_, order_preserving_step(topology_, q_, dq_, kKeepArc));
  a = allowed_move(forces_, q_, dq_, keep_segments(q_, dq_, a));
  for (int k = 0; k < kMaxTurnHalvings && turns_too_far(q_, dq_, a); ++k) a *= 0.5;
  return a;
}

double StepObjective::keep_segments(const VecX& q, const VecX& dq, double a) const {
  for (int i = 0; i + 1 < topology_.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology_.segment_kind[v] == SegmentKind::none) continue;
    const int n0 = topology_.visit_node[v], n1 = topology_.visit_node[v + 1];
    if (ends_ != nullptr && (ends_->contains_node(n0) || ends_->contains_node(n1))) continue;
    const double move = (dq.segment<3>(3 * n1) - dq.segment<3>(3 * n0)).norm();
    const double allowed = kLargestMove * (q.segment<3>(3 * n1) - q.segment<3>(3 * n0)).norm();
    if (a * move > allowed) a = allowed / move;
  }
  return a;
}

bool StepObjective::overstretched(const VecX& q) const {
  const double allowed = (1.0 + kLargestGuessStrain) * term_of<Stretch>(forces_).length_factor();
  for (int i = 0; i + 1 < topology_.num_visits(); ++i) {
    const auto v = static_cast<std::size_t>(i);
    if (topology_.segment_kind[v] == SegmentKind::none) continue;
    const Vec3 d = q.segment<3>(3 * topology_.visit_node[v + 1]) - q.segment<3>(3 * topology_.visit_node[v]);
    const int u0 = topology_.arc_coord(i);
    if (d.norm() > allowed * (q[u0 + 1] - q[u0])) return true;
  }
  return false;
}

bool StepObjective::turns_too_far(const VecX& q, const VecX& dq, double a) const {
  const auto& wraps = term_of<Wrapping>(forces_);
  for (int k = 0; k < wraps.size(); ++k) {
    const auto coords = wraps.coords(k);
    const Vec<12> x = gather(coords, q), moved = x + a * gather(coords, dq);
    if (std::abs(wrap_excess(angle(moved), angle(x))) <= kLargestTurn) continue;
    if (fade(x) > 0.0 && fade(moved) > 0.0) return true;  // along the axis psi means nothing
  }
  return false;
}

void StepObjective::extrapolate(VecX& y, double h, const VecX& v) {
  VecX step = VecX::Zero(y.size());
  for (int c = 0; c < map_.num_coords(); ++c)
    if (const int d = map_.dof_of(c); d >= 0) step[d] = h * v[c];
  double a = max_step(y, step);
  for (int k = 0; k < kMaxGuessHalvings; ++k, a *= 0.5) {
    const VecX guess = y + a * step;
    if (!std::isfinite(value(guess))) continue;  // fills q_
    if (overstretched(q_)) continue;
    y = guess;
    return;
  }
}

}  // namespace slipstitch
