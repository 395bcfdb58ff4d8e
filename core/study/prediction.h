// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/calibration.h"

namespace slipstitch {

/// What a run is expected to take.
struct RunPrediction {
  double steps = 0.0, iterations = 0.0;  // Newton's
  double wall_s = 0.0;                   // on this machine, with one thread
};

/// The same for another tolerance than the scene's own, with numerics chosen by the run.
struct TolerancePrediction {
  double tolerance_m = 0.0;
  RunPrediction run;
};

/// What a prediction rests on.
enum class Basis {
  whole_run,      // made, being short
  first_moments,  // as far as there was time
  canned_run,     // of a swatch, as a single iteration of this scene takes too long
};

struct PilotBasis {
  Basis basis = Basis::canned_run;
  double until_s = 0.0;      // simulated
  double tolerance_m = 0.0;  // of the run that was begun; 0: fixed numerics
};

/// What a scene takes, as far as can be told before it is run.
struct Prediction {
  int loops = 0, nodes = 0, dofs = 0;
  int frames = 0;
  std::optional<long> least_steps;  // if no step has to be cut; not known where the run chooses them
  std::vector<std::string> effects;
  long hessian_nonzeros = 0;  // lower triangle
  double memory_bytes = 0.0;  // of a process that runs it
  /// The scene as it is. None for static solves, of as many iterations as they take, that the pilot did not finish.
  std::optional<RunPrediction> as_it_is;
  PilotBasis as_it_is_basis;
  double budget_tolerance_m = 0.0;  // that a scene with a budget is expected to come to; 0: none, or it does not move
  std::vector<TolerancePrediction> to_tolerance;  // of a moving scene, coarse to fine: 1 mm, 0.1 mm, 0.01 mm
  PilotBasis to_tolerance_basis;
  std::string run_fails;  // why a pilot of the scene as it is ended; empty: none did
  std::string failure;    // why there is no prediction: there is no model
};

struct PredictOptions {
  const Calibration* calibration = nullptr;  // required
  Clock clock = steady_clock_s;
  double budget_s = 2.0;         // of wall time for pilots; 0: none
  double program_bytes = 2.5e7;  // that a process takes before it has a scene
};

/// Builds the model, from drawn loops because relaxing them changes no count, and runs pilots: the scene as it is for
/// its first moments, for a share of the budget and no more than about a tenth of what the whole run would take; then,
/// of a moving scene, the same to kPilotTolerance_m and, where that one gets to its end, to ever finer tolerances.
/// `scene` must be checked. Of one that leaves its effects to the program: with all candidates, without choosing.
Prediction predict(const Scene& scene, const PredictOptions& options);

}  // namespace slipstitch
