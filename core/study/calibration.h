// SPDX-License-Identifier: MIT
#pragma once

#include "study/pilot.h"

namespace slipstitch {

/// Tolerance of the coarsest pilot, and of the canned run: fine enough that its steps follow the motion [m].
inline constexpr double kPilotTolerance_m = 1e-2;

/// What is known of this machine and of how this version of the program runs a canned swatch.
struct Calibration {
  IterationCost cost;
  ProblemSize sheet;          // of the largest swatch
  RunCourse fixed, accurate;  // of the smallest, with fixed numerics at their defaults and to kPilotTolerance_m
};

/// Runs swatches that hang from two corners, for about a second where nothing else runs.
Calibration calibrate(const Clock& clock);

/// Whether it can be used: costs that are positive and finite, courses that ascend.
bool is_sound(const Calibration& calibration);

}  // namespace slipstitch
