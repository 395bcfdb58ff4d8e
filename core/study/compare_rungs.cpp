// SPDX-License-Identifier: MIT
#include "study/compare_rungs.h"

#include <algorithm>
#include <functional>

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

Horizon common_horizon(const RungDifferences& differences, const std::vector<double>& parting_m, double least_m) {
  Horizon horizon;
  std::vector<std::size_t> known;
  for (const auto& difference : differences) {
    horizon.own.push_back(0);
    if (!difference) continue;
    const std::size_t all = difference->max_m.size();
    horizon.own.back() = parting_m.empty() ? all : predictable_frames(difference->max_m, parting_m, least_m);
    known.push_back(horizon.own.back());
  }
  std::sort(known.begin(), known.end(), std::greater<>());
  if (!known.empty()) horizon.frames = known[(known.size() - 1) / 2];
  return horizon;
}

std::optional<double> smallest_error(const RungDifferences& differences, const Horizon& horizon) {
  std::optional<double> least;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (!differences[i] || horizon.own[i] < horizon.frames) continue;
    const double error = largest(differences[i]->max_m, horizon.frames);
    least = least ? std::min(*least, error) : error;
  }
  return least;
}

}  // namespace slipstitch
