// SPDX-License-Identifier: MIT
#include "study/compare_rungs.h"

#include <algorithm>
#include <limits>

namespace slipstitch {

RungDifferences compare_rungs(const Scene& scene, const std::vector<RungResult>& rungs, StudyRuns& runs,
                              const FrameTrace& reference) {
  RungDifferences differences;
  for (const RungResult& result : rungs) {
    auto& slot = differences.emplace_back();
    if (!result.no_result.empty()) continue;
    if (const std::optional<KeptRun> kept = runs.find(study_run(scene, result.rung)))
      slot = difference(kept->trace, reference);
  }
  return differences;
}

std::size_t common_frames(const RungDifferences& differences, const std::vector<double>& parting_m, double least_m) {
  std::size_t frames = std::numeric_limits<std::size_t>::max();
  if (parting_m.empty()) return frames;
  for (const auto& difference : differences)
    if (difference) frames = std::min(frames, predictable_frames(difference->max_m, parting_m, least_m));
  return frames;
}

std::optional<double> smallest_error(const RungDifferences& differences, std::size_t frames) {
  std::optional<double> least;
  for (const auto& difference : differences) {
    if (!difference) continue;
    const double error = largest(difference->max_m, frames);
    least = least ? std::min(*least, error) : error;
  }
  return least;
}

}  // namespace slipstitch
