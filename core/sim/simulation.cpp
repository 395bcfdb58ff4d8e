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
#include "force/sliding_friction.h"
#include "sim/moves.h"
#include "sim/step_objective.h"

namespace slipstitch {
namespace {

// Yarn is stiff as k_s/D: in a segment of next to no length the Newton step is small whatever the force, and says
// nothing.
constexpr double kKeepArcInAStep = 0.05;
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

}  // namespace

Simulation::Simulation(Model model, std::unique_ptr<LinearSolver> solver)
    : model_(std::move(model)),
      forces_(make_forces(model_)),
      map_(make_dof_map(model_)),
      assembly_(forces_, map_),
      ends_(model_.topology, forces_, map_),
      solver_(std::move(solver)) {
  state_ = start_state(model_, forces_);
}

void Simulation::begin_step(const StepContext& step) {
  const Stopwatch watch(wall_["begin_step"]);
  std::apply([&](auto&... term) { (term.begin_step(step), ...); }, forces_);
}

StepReport Simulation::step(double h, const FixedNumerics& numerics, const std::function<bool()>& should_stop) {
  begin_step({h, state_});
  VecX start = state_.q;
  apply_scripts(model_, state_.t + h, start);
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
    objective.settle_on_their_own(ends_, kEndsTolerance * h * numerics.velocity_tolerance_m_per_s);
  }
  const VecX unmoved = y;
  const bool follows = objective.follow_scripts(y, state_.q, solver);
  const bool risen = !follows && !quasi_static() && objective.extrapolate(y, h, state_.v);

  NewtonOptions options;
  options.max_iterations = numerics.max_newton_iterations;
  options.should_stop = should_stop;
  if (quasi_static()) {
    options.gradient_tolerance = numerics.force_tolerance_n;
    options.relative_shift = 1e-9;
  } else {
    options.step_tolerance = h * numerics.velocity_tolerance_m_per_s;
  }
  if (model_.naive.unfiltered_steps) objective.allow_any_step();
  options.convex_fallback = !model_.naive.unprojected_hessian;
  if (model_.naive.one_solve) options.max_iterations = 1;
  report.newton = newton(objective, solver, options, y);
  if (risen && report.newton.status == NewtonStatus::converged && objective.value(y) > objective.value(unmoved)) {
    y = unmoved;
    const NewtonReport first = report.newton;
    report.newton = newton(objective, solver, options, y);
    report.newton.iterations += first.iterations;
    report.newton.factorizations += first.factorizations;
    report.newton.convex_hessians += first.convex_hessians;
  }
  report.residual = quasi_static() ? report.newton.max_gradient : report.newton.max_step / h;
  report.accepted = report.newton.status == NewtonStatus::converged ||
                    (model_.naive.one_solve && report.newton.status == NewtonStatus::too_many_iterations);
  VecX q;
  expand(map_, y, q);
  if (report.accepted && objective.at_arc_floor(y)) report.fault = StepFault::arc_floor;
  // Equilibria may be far from each other however short the step.
  if (report.accepted && !quasi_static() && outgrown(forces_, q)) report.fault = StepFault::outgrown;
  report.accepted = report.accepted && report.fault == StepFault::none;
  if (report.accepted) {
    accept(h, q);
  } else if (report.newton.status != NewtonStatus::cancelled) {
    blame(y, report);
  }
  return report;
}

bool Simulation::push_out_of_scripts(VecX& start, StepReport& report) {
  VecX push = start;
  push_out(forces_, state_.q, start);
  push = start - push;
  if (state_.t == 0.0) {  // what a scene starts within a body comes out of it, however far
    VecX out = state_.q;
    push_out(forces_, state_.q, out);
    push -= out - state_.q;
  }
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

void Simulation::blame(const VecX& y, StepReport& report) const {
  if (report.newton.worst < 0) return;
  for (int c = 0; c < map_.num_coords(); ++c)
    if (map_.dof_of(c) == report.newton.worst) report.worst_coord = c;
  VecX q;
  expand(map_, y, q);
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

void Simulation::accept(double h, const VecX& q) {
  const VecX v = (q - state_.q) / h;
  term_of<Bending>(forces_).creep(h, q, state_.set_angle);
  const auto& friction = term_of<SlidingFriction>(forces_);
  state_.p = term_of<Inertia>(forces_).momentum(state_.q, v);
  term_of<BodyInertia>(forces_).put_momentum(v, state_.p);
  state_.touches = term_of<ColliderFriction>(forces_).touches_at(term_of<ColliderContact>(forces_), q);
  state_.body_touches = term_of<BodyFriction>(forces_).touches_at(term_of<BodyContact>(forces_), q);
  state_.v = v;
  state_.q = q;
  state_.t += h;
  if (friction.size() > 0) friction.drag_anchors(q, state_.anchor);
}

std::map<std::string, double> Simulation::energies() {
  std::map<std::string, double> result;
  assembly_.value(forces_, state_.q);
  std::size_t i = 0;
  std::apply(
      [&](const auto&... term) {
        const auto report = [&](const auto& t, double energy) {
          using Term = std::decay_t<decltype(t)>;
          if (!kIsPotential<Term> || t.size() == 0) return;
          if constexpr (std::is_same_v<Term, Wrapping>) energy -= t.least_energy();
          result[std::string(Term::kName)] = energy;
        };
        (report(term, assembly_.energies()[i++]), ...);
      },
      forces_);
  if (const auto& inertia = term_of<Inertia>(forces_); inertia.size() > 0)
    result["kinetic"] =
        inertia.kinetic_energy(state_.q, state_.v) + term_of<BodyInertia>(forces_).kinetic_energy(state_.v);
  return result;
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
