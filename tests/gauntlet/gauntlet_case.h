// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "gauntlet/case_limits.h"
#include "model/model.h"
#include "sim/run.h"

namespace slipstitch::gauntlet {

/// How a case is run. Factors are of what its scene says.
struct Settings {
  double step_factor = 1.0, stiffness_factor = 1.0;  // of EA and EI together
  bool quasi_static = false;                         // instead of implicit Euler; not for cases that are about motion
  bool simplicial = false;                           // the other factorisation
  Integrator integrator = Integrator::implicit_euler;
  Naive naive = {};
};

struct GauntletCase {
  std::string name, about;
  Scene scene;
  Limits limits;
  bool about_motion = false;           // says nothing without inertia
  std::function<void(Model&)> change;  // of the model before it runs; may be empty
};

/// All of them, by name unique.
std::vector<GauntletCase> gauntlet_cases();

/// The one that is too large for any settings but its own.
GauntletCase largest_case();

/// The groups of gauntlet_cases().
std::vector<GauntletCase> yarn_cases();
std::vector<GauntletCase> swatch_cases();
std::vector<GauntletCase> collision_cases();
std::vector<GauntletCase> extreme_cases();

/// The case's scene as these settings have it.
Scene scene_of(const GauntletCase& item, const Settings& settings);

enum class Outcome { passed, cut, refused, failed };
std::string_view to_string(Outcome outcome);

struct Reading {
  std::string invariant;
  double share = 0.0;  // worst over the run; above 1 it is broken
  double t = 0.0;      // when [s]
};

struct CellResult {
  Outcome outcome = Outcome::failed;
  std::string why;       // of a refusal or a failure
  bool gave_up = false;  // the failure is that the solver took too long or stopped; what it did is sound
  std::vector<Reading> readings;
  RunSummary summary;
  long passages = 0;      // of yarn through yarn that is no neighbour
  long energy_rises = 0;  // steps in which more energy came up than work was done
  double end_speed_m_per_s = 0.0;
};

/// Runs one case and looks at every step. Where a step is shorter than the case's own, only as far as kMostSteps of it.
CellResult run_cell(const GauntletCase& item, const Settings& settings);
inline constexpr double kMostSteps = 300.0;
inline constexpr double kStepsToRest = 20.0;  // of a run that must end at rest, at least

}  // namespace slipstitch::gauntlet
