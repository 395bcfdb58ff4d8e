// SPDX-License-Identifier: MIT
#pragma once

#include "study/study_runs.h"

namespace slipstitch {

struct FoundReference {
  StudyReference facts;                       // but for what depends on the horizon: set_reference_error()
  FrameTrace trace;                           // empty: there is none
  std::vector<double> parting_m;              // of its twin, by frame; empty: there is none
  std::vector<std::vector<double>> change_m;  // from every refinement to the next, by frame
  bool first_is_halved = false;               // the first of them: from a rung with twice its step
};

/// Refines SDIRK2, or the static solve, beyond all rungs that have a result: the step halves and Newton's tolerance
/// falls to a quarter each time, until positions change by less than a tenth of the smallest error of any rung, or by
/// no more than the twin is away, or the time has come. The twin begins with noise; it is run beside the first
/// refinement and beside the last.
FoundReference find_reference(const Scene& scene, const std::vector<RungResult>& rungs, StudyRuns& runs, bool quick,
                              double until_s);

/// From the changes over the first frames. `smallest_m`: error of any rung there.
void set_reference_error(FoundReference& reference, std::size_t frames, double smallest_m);

/// Errors below do not draw a horizon [m].
double least_error(const Scene& scene);

}  // namespace slipstitch
