// SPDX-License-Identifier: MIT
#include "gauntlet/random_runs.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <numeric>

#include "gauntlet/in_parallel.h"
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

RandomTally run_random(std::uint64_t first, int count, int jobs,
                       const std::function<void(const GauntletCase&, const CellResult&, double wall_s)>& on_run) {
  RandomTally tally;
  std::mutex one_at_a_time;
  in_parallel(static_cast<std::size_t>(count), jobs, [&](std::size_t i) {
    const std::uint64_t seed = first + i;
    const auto start = std::chrono::steady_clock::now();
    const GauntletCase item = random_case(seed);
    const CellResult result = run_guarded(item);
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::lock_guard lock(one_at_a_time);
    ++tally.outcomes[static_cast<std::size_t>(result.outcome)];
    if (result.outcome == Outcome::failed) tally.failures.push_back({seed, item.about, result.why, result.gave_up});
    if (on_run) on_run(item, result, wall);
  });
  std::sort(tally.failures.begin(), tally.failures.end(), [](const auto& a, const auto& b) { return a.seed < b.seed; });
  return tally;
}

std::string random_text(const RandomTally& tally) {
  std::string text;
  for (const RandomTally::Failure& failure : tally.failures)
    text += "seed " + std::to_string(failure.seed) + (failure.gave_up ? " gave up: " : " broke: ") + failure.why +
            " (" + failure.about + ")\n";
  const auto count = [&](Outcome outcome) { return std::to_string(tally.count(outcome)); };
  return text + "random scenes: " + count(Outcome::passed) + " pass, " + count(Outcome::cut) +
         " pass with steps cut, " + count(Outcome::refused) + " are refused, " + count(Outcome::failed) + " fail, " +
         std::to_string(tally.gave_up()) + " of them because the solver gave up\n";
}

std::string random_markdown(std::uint64_t first, const RandomTally& tally) {
  const int all = std::accumulate(tally.outcomes.begin(), tally.outcomes.end(), 0);
  return "\n## Random scenes\n\nSeeds " + std::to_string(first) + " to " +
         std::to_string(first + static_cast<std::uint64_t>(all) - 1) +
         ": patterns, parameters, bodies and scripts drawn anew for each.\n\n```\n" + random_text(tally) + "```\n";
}

}  // namespace slipstitch::gauntlet
