// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "study/study_runs.h"
#include "study/trace_difference.h"

namespace slipstitch {

/// Of every rung to a reference, in their order; none of those without a result.
using RungDifferences = std::vector<std::optional<TraceDifference>>;
RungDifferences compare_rungs(const Scene& scene, const std::vector<RungResult>& rungs, StudyRuns& runs,
                              const FrameTrace& reference);

/// How long positions are compared.
struct Horizon {
  std::size_t frames = 0;        // of all rungs
  std::vector<std::size_t> own;  // in which a rung's positions can be told to its error (predictable_frames); of each
};

/// That of half of the rungs: one that is much more accurate than they are would leave nothing to compare. `parting_m`:
/// empty if nothing is known; then to the end.
Horizon common_horizon(const RungDifferences& differences, const std::vector<double>& parting_m, double least_m);

/// Over the horizon, of any rung that is not farther than that from being told; none without rungs.
std::optional<double> smallest_error(const RungDifferences& differences, const Horizon& horizon);

}  // namespace slipstitch
