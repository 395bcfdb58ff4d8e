// SPDX-License-Identifier: MIT
#include "sim/simulation.h"

#include <chrono>
#include <cmath>

#include "force/bending.h"
#include "force/body_contact.h"
#include "force/body_friction.h"
#include "force/body_inertia.h"
#include "force/collider_contact.h"
#include "force/collider_friction.h"
#include "force/inertia.h"
#include "force/segments.h"
#include "force/sliding_friction.h"
#include "sim/moves.h"
#include "sim/step_objective.h"
#include "sim/stored_energy.h"

namespace slipstitch {
namespace {

// Yarn is stiff as k_s/D: in a segment of next to no length the Newton step is small whatever the force, and says
// nothing.
constexpr double kKeepArcInAStep = 0.05;
constexpr double kRestless_s = 0.05;
constexpr double kFarthestPush = 0.9;   // radii, of a node; two against each other take yarn through yarn
constexpr double kEndsTolerance = 0.1;  // share of the step tolerance to which loose ends are solved

class TimedSolver final : public LinearSolver {
 public:
  TimedSolver(LinearSolver& inner, std::map<std::string, double>& wall, long& solves)
      : inner_(inner), wall_(wall), solves_(solves) {}
  LinearStatus factor(const SparseMatrix& a) override {
    const Stopwatch watch(wall_["factor"]);
    return inner_.factor(a);
  }
  LinearStatus solve(const VecX& b, VecX& x) override {
    const Stopwatch watch(wall_["solve"]);
    ++solves_;
    return inner_.solve(b, x);
  }
  std::string name() const override { return inner_.name(); }

 private:
  LinearSolver& inner_;
  std::map<std::string, double>& wall_;
  long& solves_;
};

/// The most that a static solve may add to the Hessian so that no Newton step is endless where yarn moves freely: the
/// mass at every unknown, as if a step took kRestless_s. A share of the Hessian is more than that where segments of no
/// length, or damping in a step of no length, are so stiff that next to nothing of them would hold all else.
VecX resistance(const Model& model, const DofMap& map) {
  const Topology& topology = model.topology;
  VecX shift = VecX::Zero(map.num_dofs);
  const auto add = [&](int coord, double mass) {
    if (const int dof = map.dof_of(coord); dof >= 0) shift[dof] += mass / (kRestless_s * kRestless_s);
  };
  for_each_owned_segment(topology, [&](int yarn, int i) {
    const double half = 0.5 * linear_density(model, yarn) * rest_length(topology, i);
    for (const int visit : {i, i + 1}) {
      const int x = topology.x_coord(topology.visit_node[static_cast<std::size_t>(visit)]);
      for (int c = 0; c < 3; ++c) add(x + c, half);
      add(topology.arc_coord(visit), half);
    }
  });
  return shift;
}

State start_state(const Model& model, const YarnForces& forces) {
  State state;
  state.q = model.start_q;
  state.v = model.start_v;
  state.p = term_of<Inertia>(forces).momentum(state.q, state.v);
  term_of<BodyInertia>(forces).put_momentum(state.v, state.p);
  if (term_of<SlidingFriction>(forces).size() > 0) state.anchor = state.q.tail(model.topology.num_visits());
  if (model.effects.plasticity) state.set_angle = VecX::Zero(model.topology.num_visits());
  return state;
}

/// What a scene starts within bodies comes out of them, however far, before it begins to move: a step that took it out
/// would be one in which it flies. The forces are its own: those of the run have begun no step yet.
void leave_bodies(const Model& model, State& state) {
  YarnForces forces = make_forces(model);
  const StepContext no_time{0.0, state};
  const auto look_around = [&](auto& term) {
    if constexpr (PushesOut<std::decay_t<decltype(term)>>) term.begin_step(no_time);
  };
  std::apply([&](auto&... term) { (look_around(term), ...); }, forces);
  VecX out = state.q;
  push_out(forces, state.q, out);
  if (out == state.q) return;
  state.q = out;
  state.p = term_of<Inertia>(forces).momentum(state.q, state.v);
  term_of<BodyInertia>(forces).put_momentum(state.v, state.p);
}

}  // namespace

Simulation::Simulation(Model model, std::unique_ptr<LinearSolver> solver)
    : model_(std::move(model)),
      forces_(make_forces(model_)),
      map_(make_dof_map(model_)),
      assembly_(forces_, map_),
      ends_(model_.topology, forces_, map_),
      solver_(std::move(solver)) {
  state_ = start_state(model_, forces_);
  if (quasi_static()) resistance_ = resistance(model_, map_);
  if (model_.effects.colliders) leave_bodies(model_, state_);
}

void Simulation::begin_step(const StepContext& step) {
  const Stopwatch watch(wall_["begin_step"]);
  std::apply([&](auto&... term) { (term.begin_step(step), ...); }, forces_);
}

StepReport Simulation::solve(const StepContext& step, const How& how) {
  const FixedNumerics& numerics = how.numerics;
  begin_step(step);
  VecX start = state_.q;
  apply_scripts(model_, step.end_t(), start);
  for (int c = 0; c < map_.num_coords(); ++c)
    if (map_.dof_of(c) < 0) map_.offset[c] = start[c];

  StepObjective objective(forces_, map_, assembly_, model_.topology, wall_);
  TimedSolver solver(*solver_, wall_, linear_solves_);
  VecX y;
  StepReport report;
  if (!push_out_of_scripts(start, report)) return report;
  restrict_to_dofs(map_, start, y);
  objective.keep_arcs(state_.q, quasi_static() ? 0.0 : kKeepArcInAStep, model_.yarn.stretch_n);
  objective.predict(y, VecX::Zero(y.size()));
  if (!quasi_static()) {
    objective.settle_on_their_own(ends_, kEndsTolerance * step.h * numerics.velocity_tolerance_m_per_s);
  }
  const VecX unmoved = y;
  const bool risen = start_from_guess(step, how.aid, objective, solver, y);

  NewtonOptions options;
  options.max_iterations = numerics.max_newton_iterations;
  options.should_stop = how.should_stop;
  if (quasi_static()) {
    options.gradient_tolerance = numerics.force_tolerance_n;
    options.relative_shift = 1e-9;
    options.most_shift = resistance_;
  } else {
    options.step_tolerance = step.h * numerics.velocity_tolerance_m_per_s;
    options.foresee = how.aid.foresee;
  }
  if (model_.naive.unfiltered_steps) objective.allow_any_step();
  options.convex_fallback = !model_.naive.unprojected_hessian;
  const bool one_solve = numerics.integrator == Integrator::linearised_euler && !quasi_static();
  if (one_solve) options.max_iterations = 1;
  report.newton = newton(objective, solver, options, y);
  if (risen && report.newton.status == NewtonStatus::converged && objective.value(y) > objective.value(unmoved)) {
    y = unmoved;
    const NewtonReport first = report.newton;
    report.newton = newton(objective, solver, options, y);
    add_counts(first, report.newton);
  }
  report.residual = quasi_static() ? report.newton.max_gradient : report.newton.max_step / step.h;
  report.accepted = report.newton.status == NewtonStatus::converged ||
                    (one_solve && report.newton.status == NewtonStatus::too_many_iterations);
  VecX q;
  expand(map_, y, q);
  if (report.accepted && objective.at_arc_floor(y)) report.fault = StepFault::arc_floor;
  // Equilibria may be far from each other however short the step.
  if (report.accepted && !quasi_static() && outgrown(forces_, q)) report.fault = StepFault::outgrown;
  report.accepted = report.accepted && report.fault == StepFault::none;
  if (report.accepted) {
    accept(step, q);
  } else if (report.newton.status != NewtonStatus::cancelled) {
    blame(y, report);
  }
  return report;
}

/// Moves y; whether the value there is higher.
bool Simulation::start_from_guess(const StepContext& step, const StepAid& aid, StepObjective& objective,
                                  LinearSolver& solver, VecX& y) {
  const auto extrapolate = [&](VecX& from) {
    return objective.extrapolate(
        from, aid.expected ? VecX(aid.expected(step.end_t()) - state_.q) : VecX(step.duration * state_.v));
  };
  if (quasi_static()) {
    objective.follow_scripts(y, state_.q, solver);
    return false;
  }
  VecX guess = y;
  Guess led = Guess::none;
  if (aid.motion_first) led = extrapolate(guess);
  if (led != Guess::lower && objective.follow_scripts(y, state_.q, solver)) return false;
  if (!aid.motion_first) led = extrapolate(guess);
  if (led != Guess::none) y = guess;
  return led == Guess::higher;
}

bool Simulation::push_out_of_scripts(VecX& start, StepReport& report) {
  VecX push = start;
  push_out(forces_, state_.q, start);
  push = start - push;
  for (int n = 0; n < model_.topology.num_nodes; ++n) {
    if (push.segment<3>(3 * n).norm() <= kFarthestPush * model_.yarn.radius_m) continue;
    report.fault = StepFault::far_push;
    report.worst_coord = 3 * n;
    return false;
  }
  if (start == state_.q || !passes(forces_, state_.q, start)) return true;
  report.fault = StepFault::far_push;
  (start - state_.q).head(3 * model_.topology.num_nodes).cwiseAbs().maxCoeff(&report.worst_coord);
  return false;
}

namespace {

/// A coordinate of the first stencil whose energy is not finite; -1: there is none.
template <class Term>
int not_finite_at(const Term& term, const VecX& q) {
  Vec<Term::kSize> local;
  for (int k = 0; k < term.size(); ++k) {
    const auto coords = term.coords(k);
    for (int i = 0; i < Term::kSize; ++i) local[i] = q[coords[static_cast<std::size_t>(i)]];
    if (!std::isfinite(term.eval(k, local, nullptr, nullptr))) return coords[0];
  }
  return -1;
}

}  // namespace

void Simulation::blame(const VecX& y, StepReport& report) const {
  VecX q;
  expand(map_, y, q);
  if (report.newton.status == NewtonStatus::not_finite) return blame_not_finite(q, report);
  if (report.newton.worst < 0) return;
  for (int c = 0; c < map_.num_coords(); ++c)
    if (map_.dof_of(c) == report.newton.worst) report.worst_coord = c;
  std::vector<char> wanted(static_cast<std::size_t>(map_.num_coords()), 0);
  wanted[static_cast<std::size_t>(report.worst_coord)] = 1;
  double largest = 0.0;
  const auto compare = [&](const auto& term) {
    using Term = std::decay_t<decltype(term)>;
    if (std::is_same_v<Term, Inertia> || std::is_same_v<Term, BodyInertia>) return;
    VecX gradient = VecX::Zero(q.size());
    add_full_gradient(term, q, wanted, gradient);
    const double force = std::abs(gradient[report.worst_coord]);
    if (force <= largest) return;
    largest = force;
    report.worst_term = Term::kName;
  };
  std::apply([&](const auto&... term) { (compare(term), ...); }, forces_);
}

void Simulation::blame_not_finite(const VecX& q, StepReport& report) const {
  const auto look = [&](const auto& term) {
    if (report.worst_coord >= 0) return;
    report.worst_coord = not_finite_at(term, q);
    if (report.worst_coord >= 0) report.worst_term = std::decay_t<decltype(term)>::kName;
  };
  std::apply([&](const auto&... term) { (look(term), ...); }, forces_);
}

void Simulation::accept(const StepContext& step, const VecX& q) {
  const VecX from = step.sum(VecX(VecX::Zero(q.size())), [](const Past& known) -> const VecX& { return *known.q; });
  const VecX v = (q - from) / step.h;
  term_of<Bending>(forces_).creep(step.duration, q, state_.set_angle);
  const auto& friction = term_of<SlidingFriction>(forces_);
  state_.p = term_of<Inertia>(forces_).momentum(*step.near_q, v);
  term_of<BodyInertia>(forces_).put_momentum(v, state_.p);
  state_.touches = term_of<ColliderFriction>(forces_).touches_at(term_of<ColliderContact>(forces_), q);
  state_.body_touches = term_of<BodyFriction>(forces_).touches_at(term_of<BodyContact>(forces_), q);
  state_.v = v;
  state_.q = q;
  state_.t = step.end_t();
  if (friction.size() > 0) friction.drag_anchors(q, state_.anchor);
}

std::map<std::string, double> Simulation::energies() {
  assembly_.value(forces_, state_.q);
  return stored_energies(forces_, state_, assembly_.energies());
}

VecX Simulation::reactions() const {
  VecX gradient = VecX::Zero(map_.num_coords());
  std::apply([&](const auto&... term) { (add_full_gradient(term, state_.q, {}, gradient), ...); }, forces_);
  for (int c = 0; c < map_.num_coords(); ++c)
    if (map_.dof_of(c) >= 0) gradient[c] = 0.0;
  return gradient;
}

double order_preserving_step(const Topology& topology, const VecX& q, const VecX& dq, double keep) {
  double a = 1.0;
  for (int i = 0; i + 1 < topology.num_visits(); ++i) {
    if (topology.segment_kind[static_cast<std::size_t>(i)] == SegmentKind::none) continue;
    const int u0 = topology.arc_coord(i);
    const double gap = q[u0 + 1] - q[u0], change = dq[u0 + 1] - dq[u0];
    if (gap + a * change < keep * gap) a = (1.0 - keep) * gap / -change;
  }
  return a;
}

}  // namespace slipstitch
