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
constexpr double kLargestTurn = kPi / 4.0;  // of a wrap in one Newton step
constexpr int kMaxTurnHalvings = 8;
constexpr double kLargestMove = 0.7;         // of one end of a segment against the other in one Newton step, in its length
constexpr double kLargestGuessStrain = 0.05;  // of a segment in the extrapolated start
constexpr int kMaxGuessHalvings = 4;
constexpr double kSmallMove = 1e-8;  // of what is held, for the derivative by it [m]

Vec<12> gather(const std::array<int, 12>& coords, const VecX& q) {
  Vec<12> x;
  for (int i = 0; i < 12; ++i) x[i] = q[coords[static_cast<std::size_t>(i)]];
  return x;
}

double angle(const Vec<12>& x) {
  return wrap_angle(x.segment<3>(0), x.segment<3>(3), x.segment<3>(6), x.segment<3>(9));
}

}  // namespace

double StepObjective::value(const VecX& y) {
  const Stopwatch watch(wall_["energy"]);
  expand(map_, y, q_);
  return assembly_.value(forces_, q_) + barrier_.value(q_);
}

double StepObjective::derivatives(const VecX& y, HessianMode mode, VecX& g, SparseMatrix& h) {
  const Stopwatch watch(wall_["assembly"]);
  expand(map_, y, q_);
  const double energy = assembly_.derivatives(forces_, q_, mode, g, h);
  barrier_.add_derivatives(q_, map_, g, h);
  return energy + barrier_.value(q_);
}

void StepObjective::settle_on_their_own(LooseEnds& ends, double step_tolerance) {
  ends_ = &ends;
  ends_tolerance_ = step_tolerance;
}

void StepObjective::keep_arcs(const VecX& q, double share, double stiffness) {
  barrier_.keep(topology_, q, share, stiffness);
}

bool StepObjective::at_arc_floor(const VecX& y) {
  expand(map_, y, q_);
  return barrier_.active(q_);
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
  if (!filtered_) return 1.0;
  const Stopwatch watch(wall_["step_limits"]);
  expand(map_, y, q_);
  expand(map_, y + dy, dq_);
  dq_ -= q_;
  return max_way(q_, dq_);
}

double StepObjective::max_way(const VecX& q, const VecX& dq) {
  double a = barrier_.max_step(q, dq, order_preserving_step(topology_, q, dq, kKeepArc));
  a = allowed_move(forces_, q, dq, keep_segments(q, dq, a));
  for (int k = 0; k < kMaxTurnHalvings && turns_too_far(q, dq, a); ++k) a *= 0.5;
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
    const double L = wraps.wrap(k).L;
    if (wrap_fade(x, L) > 0.0 && wrap_fade(moved, L) > 0.0) return true;  // where it is gone psi means nothing
  }
  return false;
}

bool StepObjective::follow_scripts(VecX& y, const VecX& q0, LinearSolver& solver) {
  expand(map_, y, q_);
  VecX way = VecX::Zero(q0.size());
  for (int c = 0; c < map_.num_coords(); ++c)
    if (map_.dof_of(c) < 0) way[c] = q_[c] - q0[c];
  const double farthest = way.cwiseAbs().maxCoeff();
  if (!(farthest > 0.0)) return false;
  const double here = value(y);
  const double share = kSmallMove / farthest;
  VecX gradient, moved;
  SparseMatrix h;
  assembly_.derivatives(forces_, q0 + share * way, HessianMode::convex, moved, h);
  LinearStatus status = LinearStatus::not_positive_definite;
  for (const HessianMode mode : {HessianMode::exact, HessianMode::convex}) {
    assembly_.derivatives(forces_, q0, mode, gradient, h);
    status = solver.factor(h);
    if (status == LinearStatus::ok) break;
  }
  VecX dy;
  if (status != LinearStatus::ok || solver.solve(-(gradient + (moved - gradient) / share), dy) != LinearStatus::ok)
    return false;
  for (int c = 0; c < map_.num_coords(); ++c)
    if (const int d = map_.dof_of(c); d >= 0) way[c] = dy[d];
  VecX from;
  restrict_to_dofs(map_, q0, from);
  const VecX guess = from + max_way(q0, way) * dy;
  if (!(value(guess) < here)) return false;
  y = guess;
  return true;
}

Guess StepObjective::extrapolate(VecX& y, const VecX& way) {
  VecX step = VecX::Zero(y.size());
  for (int c = 0; c < map_.num_coords(); ++c)
    if (const int d = map_.dof_of(c); d >= 0) step[d] = way[c];
  const double here = value(y);
  double a = max_step(y, step);
  for (int k = 0; k < kMaxGuessHalvings; ++k, a *= 0.5) {
    const VecX guess = y + a * step;
    const double there = value(guess);  // fills q_
    if (!std::isfinite(there) || overstretched(q_)) continue;
    y = guess;
    return there > here ? Guess::higher : Guess::lower;
  }
  return Guess::none;
}

}  // namespace slipstitch
