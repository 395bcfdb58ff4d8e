// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "gauntlet/gauntlet_case.h"

namespace slipstitch::gauntlet {

/// What came of many random scenes.
struct RandomTally {
  struct Failure {
    std::uint64_t seed = 0;
    std::string about, why;
    bool gave_up = false;  // see CellResult
  };
  std::array<int, 4> outcomes{};  // by Outcome
  std::vector<Failure> failures;

  int gave_up() const {
    return static_cast<int>(
        std::count_if(failures.begin(), failures.end(), [](const Failure& failure) { return failure.gave_up; }));
  }
  int count(Outcome outcome) const { return outcomes[static_cast<std::size_t>(outcome)]; }
};

/// Runs seeds first .. first + count - 1, one scene each. A run that throws has failed, and so has one that ends early
/// for another reason than yarn that is used up. On `jobs` threads; on_run after every one, one at a time, may be
/// empty.
RandomTally run_random(std::uint64_t first, int count, int jobs,
                       const std::function<void(const GauntletCase&, const CellResult&, double wall_s)>& on_run);

/// Totals and every failing seed, for a terminal and for stability.md.
std::string random_text(const RandomTally& tally);
std::string random_markdown(std::uint64_t first, const RandomTally& tally);

}  // namespace slipstitch::gauntlet
