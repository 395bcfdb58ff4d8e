// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slipstitch {

/// Why one effect is simulated or not.
struct EffectVerdict {
  std::string effect;
  bool kept = false;
  std::string why;
  std::optional<double> difference_m;  // largest, of any node at any frame of the window, with and without, up to where
                                       // it proved to matter; absent: not observed
};

/// How the effects of a run were chosen: from what was seen in a window of time, which proves nothing about what comes
/// after it, but for the verdicts that state a bound.
struct EffectChoice {
  double window_s = 0.0;     // simulated time observed, from the start
  double tolerance_m = 0.0;  // differences below do not matter
  double wall_s = 0.0;       // what finding out took
  std::vector<EffectVerdict> verdicts;
};

}  // namespace slipstitch
