// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "sim/arc_barrier.h"
#include "sim/assembly.h"
#include "sim/loose_ends.h"
#include "sim/simulation.h"

namespace slipstitch {

/// Adds its lifetime to a counter of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), start_(std::chrono::steady_clock::now()) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_;
};

/// What a guess did to the value; none: it leads nowhere.
enum class Guess { none, lower, higher };

/// The sum of all terms in the unknowns, with the limits on a Newton step: arc lengths keep their order, no segment
/// turns by more than about a quarter of pi, and no wrap either.
class StepObjective final : public Objective {
 public:
  StepObjective(YarnForces& forces, const DofMap& map, Assembly& assembly, const Topology& topology,
                std::map<std::string, double>& wall)
      : forces_(forces), map_(map), assembly_(assembly), topology_(topology), wall_(wall) {}

  /// From here on `ends` are solved for on their own, to step_tolerance [m]. Only with a simple map.
  void settle_on_their_own(LooseEnds& ends, double step_tolerance);

  /// See Naive::unfiltered_steps.
  void allow_any_step() { filtered_ = false; }

  /// From here on an ArcBarrier::keep() of q is part of the value.
  void keep_arcs(const VecX& q, double share, double stiffness);
  /// Whether that changes the value at y.
  bool at_arc_floor(const VecX& y);

  double value(const VecX& y) override;
  double derivatives(const VecX& y, HessianMode mode, VecX& g, SparseMatrix& h) override;
  double max_step(const VecX& y, const VecX& dy) override;
  double value_scale() const override { return assembly_.scale(); }
  void predict(const VecX& y, const VecX& dy) override;
  void settle(VecX& y, const VecX& before) override;
  double step_size(const VecX& dy) const override;

  /// Moves y along `way` (full coordinates), as far as the step limits allow and yarn that turns is not stretched by
  /// more than a twentieth: Newton removes that in one iteration and has less turning left to do, but yarn torn apart
  /// takes it many. Where the value rose the solve may end higher than it would have begun, which is no step of
  /// implicit Euler.
  Guess extrapolate(VecX& y, const VecX& way);

  /// Moves y to where the linearisation at q0, the state before the step, puts it while the held coordinates go to where
  /// scripts want them, and returns true, if the value is lower there. From a state in which only what is held has
  /// moved, its yarn torn, Newton takes many iterations or never comes back.
  bool follow_scripts(VecX& y, const VecX& q0, LinearSolver& solver);

 private:
  double max_way(const VecX& q, const VecX& dq);
  double keep_segments(const VecX& q, const VecX& dq, double a) const;
  bool turns_too_far(const VecX& q, const VecX& dq, double a) const;
  bool overstretched(const VecX& q) const;

  YarnForces& forces_;
  const DofMap& map_;
  Assembly& assembly_;
  const Topology& topology_;
  std::map<std::string, double>& wall_;
  ArcBarrier barrier_;
  bool filtered_ = true;
  LooseEnds* ends_ = nullptr;
  double ends_tolerance_ = 0.0;  // [m]
  double ends_step_ = 0.0;       // last step inside `settle` [m]
  VecX q_, dq_;                  // scratch
};

}  // namespace slipstitch
