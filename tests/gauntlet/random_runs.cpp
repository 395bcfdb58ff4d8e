// SPDX-License-Identifier: MIT
#include "gauntlet/random_runs.h"

#include <chrono>
#include <exception>

#include "gauntlet/random_scenes.h"

namespace slipstitch::gauntlet {
namespace {

/// The one good reason why a scene that should be possible ends early; a solver that gives up is none.
bool ran_out_of_yarn(const std::string& message) {
  const auto says = [&](const char* part) { return message.find(part) != std::string::npos; };
  return says("a yarn end was pulled to within") || says("a segment loses its yarn");
}

CellResult run_guarded(const GauntletCase& item) {
  try {
    CellResult result = run_cell(item, {});
    if (result.outcome == Outcome::refused && !ran_out_of_yarn(result.why)) result.outcome = Outcome::failed;
    return result;
  } catch (const std::exception& error) {
    CellResult result;
    result.why = std::string("threw: ") + error.what();
    return result;
  }
}

}  // namespace

RandomTally run_random(std::uint64_t first, int count,
                       const std::function<void(const GauntletCase&, const CellResult&, double wall_s)>& on_run) {
  RandomTally tally;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    const auto start = std::chrono::steady_clock::now();
    const GauntletCase item = random_case(seed);
    const CellResult result = run_guarded(item);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++tally.outcomes[static_cast<std::size_t>(result.outcome)];
    if (result.outcome == Outcome::failed) tally.failures.push_back({seed, item.about, result.why});
    if (on_run) on_run(item, result, wall);
  }
  return tally;
}

}  // namespace slipstitch::gauntlet
