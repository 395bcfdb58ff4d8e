// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace slipstitch::gauntlet {

/// What one case may use. Counts are of a whole run, steps and iterations at the case's own step.
struct Limits {
  double max_stretch = 1.5;                                             // of any segment, |dx| over its rest length
  long max_steps = 1000, max_newton = 6000;                             // beyond, a run has not reached its end
  long max_ridge_entries = 2, max_fade_entries = 40;                    // of wraps, see RunSummary
  long max_crushed_entries = 0;                                         // of segments, likewise
  double rest_speed_m_per_s = std::numeric_limits<double>::infinity();  // of any node at the end of its own duration
  bool isolated = false;    // nothing does work on it: it ends with no more energy than it had
  bool impossible = false;  // ends in a refusal that names place, effect and time
};

}  // namespace slipstitch::gauntlet
