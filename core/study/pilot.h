// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/scene.h"
#include "sim/clock.h"
#include "study/cost_model.h"

namespace slipstitch {

/// What a pilot may take. Whichever comes first.
struct PilotLimits {
  double wall_s = 1.0;  // by the clock, for setting up, and again for the steps
  IterationCost cost;   // no more iterations than would take wall_s by this
};

/// The first moments of a run.
struct Pilot {
  RunCourse course;       // at every step that was accepted
  bool finished = false;  // the whole run; it is known then
  std::string failure;    // why it ended by itself before; empty: it did not
  ProblemSize size;       // factor: none where no matrix was factored
  double setup_s = 0.0;   // rest shape, model, symbolic analysis
  double wall_s = 0.0;    // of the course
  double factor_s = 0.0;  // of that, in factorisations
};

/// Runs a checked scene whose effects are chosen, as far as the limits allow.
Pilot run_pilot(const Scene& scene, const PilotLimits& limits, const Clock& clock);

}  // namespace slipstitch
