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

/// Frames in which the positions of all rungs can be told to their errors (predictable_frames). `parting_m`: empty if
/// nothing is known; then all.
std::size_t common_frames(const RungDifferences& differences, const std::vector<double>& parting_m, double least_m);

/// Of any rung, over the first frames; none without rungs.
std::optional<double> smallest_error(const RungDifferences& differences, std::size_t frames);

}  // namespace slipstitch
