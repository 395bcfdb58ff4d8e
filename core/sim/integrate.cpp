// SPDX-License-Identifier: MIT
// The steps of every integrator, as solves like implicit Euler's.
#include <cmath>

#include "force/bending.h"
#include "force/sliding_friction.h"
#include "sim/moves.h"
#include "sim/simulation.h"

namespace slipstitch {
namespace {

/// Diagonal of the two-stage singly diagonally implicit method that is L-stable, 1 - 1/sqrt(2). [Alexander 1977, 2.3]
const double kSdirk = 1.0 - std::sqrt(0.5);
constexpr double kKeepArcAhead = 0.5;

/// v a time `ahead` later, as its last change has it.
VecX velocity_ahead(const State& begin, double ahead) {
  if (begin.h_before == 0.0) return begin.v;
  return begin.v + ahead / begin.h_before * (begin.v - begin.v_before);
}

bool looks_back(Integrator integrator) {
  return integrator != Integrator::implicit_euler && integrator != Integrator::linearised_euler;
}

}  // namespace

StepReport Simulation::step(double h, const FixedNumerics& numerics, const std::function<bool()>& should_stop,
                            const StepAid& aid) {
  const How how{numerics, should_stop, aid};
  const Integrator integrator = quasi_static() ? Integrator::implicit_euler : numerics.integrator;
  const VecX v = state_.v;
  StepReport report;
  if (looks_back(integrator) && state_.h_before == 0.0) {
    report = find_first_velocity(h, how);
    if (!report.accepted) return report;
  }
  const NewtonReport before = report.newton;
  const State begin = state_;
  switch (integrator) {
    case Integrator::implicit_euler:
    case Integrator::linearised_euler:
      return solve({h, begin}, how);
    case Integrator::bdf2:
      report = bdf2(begin, h, how);
      break;
    case Integrator::sdirk2:
      report = sdirk2(begin, h, how);
      break;
    case Integrator::implicit_midpoint:
      report = midpoint(begin, h, how);
      break;
  }
  add_counts(before, report.newton);
  if (!report.accepted) {
    state_ = begin;
    state_.v = v;
  } else if (looks_back(integrator)) {
    state_.h_before = h;
    state_.q_before = begin.q;
    state_.p_before = begin.p;
    if (integrator != Integrator::implicit_midpoint) state_.v_before = begin.v;
  }
  return report;
}

/// q + share (q - before), or less of it where arc lengths would come close to each other: a place to take M at, as far
/// from the solution as the square of a step.
VecX Simulation::ahead(const VecX& q, const VecX& before, double share) const {
  const VecX way = share * (q - before);
  return q + order_preserving_step(model_.topology, q, way, kKeepArcAhead) * way;
}

/// Where scripts set off at once the velocity that goes with the momentum at the start is another than the scene's, and
/// so is dT/dq there: a step of implicit Euler tells which. Without it methods of second order begin with an error of
/// the first.
StepReport Simulation::find_first_velocity(double h, const How& how) {
  State begin = state_;
  const StepReport report = solve({h, begin}, how);
  if (report.accepted) begin.v = state_.v;
  state_ = std::move(begin);
  return report;
}

/// (1 + 2r)/(1 + r) q' h = q - [(1 + r)^2 q_n - r^2 q_{n-1}]/(1 + 2r), r = h/h_{n-1}; stable for r < 2.41. The first
/// step is implicit Euler's. [Hairer, Norsett and Wanner 1993, III.5]
StepReport Simulation::bdf2(const State& begin, double h, const How& how) {
  StepContext step{h, begin};
  VecX near_q = begin.q;
  const VecX near_v = velocity_ahead(begin, h);
  step.near_q = &near_q;
  step.near_v = &near_v;
  if (begin.h_before > 0.0) {
    const double r = h / begin.h_before, weight = (1.0 + r) * (1.0 + r) / (1.0 + 2.0 * r);
    near_q = ahead(begin.q, begin.q_before, r);
    step.h = h * (1.0 + r) / (1.0 + 2.0 * r);
    step.duration = h;
    step.past = {{weight, &begin.q, &begin.p}, {1.0 - weight, &begin.q_before, &begin.p_before}};
    step.rate_past = step.past;
  }
  return solve(step, how);
}

StepReport Simulation::sdirk2(const State& begin, double h, const How& how) {
  StepContext first{kSdirk * h, begin};
  const VecX near_q = ahead(begin.q, begin.q - first.h * begin.v, 1.0), near_v = velocity_ahead(begin, first.h);
  first.near_q = &near_q;
  first.near_v = &near_v;
  const StepReport inner = solve(first, how);
  if (!inner.accepted) return inner;

  const State middle = state_;
  const double weight = (1.0 - kSdirk) / kSdirk;  // of (q_1 - q_n), which is kSdirk h v_1
  const VecX end_q = ahead(middle.q, begin.q, weight), end_v = middle.v + weight * (middle.v - begin.v);
  StepContext second{kSdirk * h, middle};
  second.duration = h - first.h;
  second.past = {{1.0 - weight, &begin.q, &begin.p}, {weight, &middle.q, &middle.p}};
  second.rate_past = second.past;
  second.near_q = &end_q;
  second.near_v = &end_v;
  StepReport report = solve(second, how);
  add_counts(inner.newton, report.newton);
  if (report.accepted) state_.t = begin.t + h;
  return report;
}

/// Half a step of implicit Euler, with M and dT/dq taken where it ends as far as is known, and the same way again.
/// v_before is that of the last midpoint, and v follows from the last two: 2 v - v_n would keep an error of v, as of
/// what scripts set in motion at once, for ever.
StepReport Simulation::midpoint(const State& begin, double h, const How& how) {
  StepContext half{0.5 * h, begin};
  const VecX near_q = ahead(begin.q, begin.q - half.h * begin.v, 1.0);
  const VecX near_v = velocity_ahead(begin, h);
  half.near_q = &near_q;
  half.near_v = &near_v;
  // The change over half a step is the rate a quarter of it earlier; what is missing is as in the step before.
  VecX last_middle;
  if (begin.h_before > 0.0) {
    const double bend = 0.5 * std::pow(h / begin.h_before, 2);
    last_middle = 0.5 * (begin.q + begin.q_before);
    half.rate_past = {{1.0 - bend, &begin.q}, {2.0 * bend, &last_middle}, {-bend, &begin.q_before}};
  }
  StepReport report = solve(half, how);
  if (!report.accepted) return report;

  State& end = state_;
  VecX q = 2.0 * end.q - begin.q;
  apply_scripts(model_, begin.t + h, q);
  const bool ordered = order_preserving_step(model_.topology, end.q, q - end.q, kKeepArcAhead) == 1.0;
  if (!ordered || passes(forces_, end.q, q)) {
    report.accepted = false;
    report.fault = StepFault::overshot;
    (q - end.q).head(3 * model_.topology.num_nodes).cwiseAbs().maxCoeff(&report.worst_coord);
    return report;
  }
  term_of<Bending>(forces_).creep(half.h, q, end.set_angle);
  if (end.anchor.size() > 0) term_of<SlidingFriction>(forces_).drag_anchors(q, end.anchor);
  end.v_before = end.v;
  if (begin.h_before > 0.0) end.v += h / (h + begin.h_before) * (end.v - begin.v_before);
  end.p = 2.0 * end.p - begin.p;
  end.q = std::move(q);
  end.t = begin.t + h;
  return report;
}

}  // namespace slipstitch
