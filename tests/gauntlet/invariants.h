// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gauntlet/case_limits.h"
#include "sim/simulation.h"

namespace slipstitch::gauntlet {

/// One accepted step and what it did. The simulation still is in it: its terms hold what they lag.
struct AcceptedStep {
  const Simulation& sim;
  const State& before;
  const State& after;
  const NewtonReport& newton;
  double h() const { return after.t - before.t; }
};

/// Something that must hold at every accepted step.
struct Invariant {
  const char* name;
  const char* meaning;
  /// As a share of what is allowed: above 1 it is broken.
  double (*share)(const AcceptedStep& step, const Limits& limits);
};

/// All of them, but what takes memory of the steps before (passages.h, energy_watch.h).
std::span<const Invariant> invariants();

}  // namespace slipstitch::gauntlet
