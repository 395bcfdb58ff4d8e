// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "model/model.h"
#include "sim/assembly.h"
#include "sim/loose_ends.h"
#include "solve/newton.h"

namespace slipstitch {

class StepObjective;

/// Why a step that Newton could do, or need not try, is refused all the same.
enum class StepFault {
  none,
  arc_floor,  // a segment has lost all yarn that one step may take
  outgrown,   // a segment that touches something has become so much longer that it could let it between its points
  overshot,   // the second half of an implicit midpoint step takes yarn through yarn or arc lengths past each other
  far_push,   // getting yarn out of what scripts have moved over it, as by a lever, takes it too far to see what it
              // passes
};

struct StepReport {
  NewtonReport newton;
  double residual = 0.0;  // max |Newton step| / h [m/s]; quasi-static: max |gradient| [N]
  bool accepted = false;
  StepFault fault = StepFault::none;
  // Of a solve that failed: the full coordinate that its last Newton step would move most (-1: none), and the term with
  // the largest force on it; of one that could not begin, a coordinate of a stencil whose energy is not finite.
  int worst_coord = -1;
  std::string worst_term;
};

/// For runs that know more than one step tells: where solves begin, and when they end.
struct StepAid {
  std::function<VecX(double t)> expected;  // q at times within the step, full coordinates; empty: along v
  bool motion_first = false;  // where that leads lower nobody asks where scripts would lead, which takes a factor
  bool foresee = false;       // NewtonOptions::foresee
};

/// One fabric in time. Each solve of a step minimises the sum of all force terms, which are its incremental potential;
/// integrators are made of such solves (integrate.cpp). Without inertia every step is an equilibrium under the step's
/// script and friction.
///
///   Simulation sim(std::move(model));
///   StepReport report = sim.step(1e-3, numerics, {});
class Simulation {
 public:
  explicit Simulation(Model model, std::unique_ptr<LinearSolver> solver = make_cholmod_solver());
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances by h [s] if the solve converges; otherwise the state is unchanged.
  StepReport step(double h, const FixedNumerics& numerics, const std::function<bool()>& should_stop,
                  const StepAid& aid = {});

  /// Goes on from a snapshot of a simulation of the same model.
  void restore(const State& state) { state_ = state; }

  const Model& model() const { return model_; }
  const State& state() const { return state_; }
  const YarnForces& forces() const { return forces_; }
  bool quasi_static() const { return !model_.effects.inertia.has_value(); }
  int num_dofs() const { return map_.num_dofs; }
  int num_nonzeros() const { return assembly_.pattern()->nonzeros(); }
  std::string solver_name() const { return solver_->name(); }
  const std::map<std::string, double>& wall_by_phase_s() const { return wall_; }
  long linear_solves() const { return linear_solves_; }
  /// Of every term that has stencils, up to now.
  EffectCosts effect_costs() const;

  /// Stored energy by potential term, and "kinetic", now [J]; of wrapping, that above every wrap at rest.
  std::map<std::string, double> energies();
  /// Force of the held coordinates' supports on the fabric at the last accepted step, full coordinates [N].
  VecX reactions() const;

 private:
  struct How {  // all solves of a step are done
    const FixedNumerics& numerics;
    const std::function<bool()>& should_stop;
    const StepAid& aid;
  };
  StepReport bdf2(const State& begin, double h, const How& how);
  StepReport sdirk2(const State& begin, double h, const How& how);
  StepReport midpoint(const State& begin, double h, const How& how);
  StepReport find_first_velocity(double h, const How& how);
  VecX ahead(const VecX& q, const VecX& before, double share) const;
  StepReport solve(const StepContext& step, const How& how);
  bool start_from_guess(const StepContext& step, const StepAid& aid, StepObjective& objective, LinearSolver& solver,
                        VecX& y);
  void begin_step(const StepContext& step);
  bool push_out_of_scripts(VecX& start, StepReport& report);
  void accept(const StepContext& step, const VecX& q);
  void blame(const VecX& y, StepReport& report) const;
  void blame_not_finite(const VecX& q, StepReport& report) const;

  Model model_;
  State state_;
  YarnForces forces_;
  DofMap map_;
  Assembly assembly_;
  LooseEnds ends_;
  std::unique_ptr<LinearSolver> solver_;
  VecX resistance_;  // of a static solve to Newton steps (num_dofs)
  std::map<std::string, double> wall_;
  long linear_solves_ = 0;
};

/// Positions of scripted nodes at time t, written into `offset` (num_coords), from their start positions.
void apply_scripts(const Model& model, double t, VecX& offset);

/// Largest a <= 1 such that moving q by a dq leaves every segment at least `keep` of its present arc length.
double order_preserving_step(const Topology& topology, const VecX& q, const VecX& dq, double keep);

}  // namespace slipstitch
