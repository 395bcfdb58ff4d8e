// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace slipstitch {

/// One thing wrong with the user's input. `path` uses the schema's spelling, e.g. "yarn.radius_m", "knit.chart.rows[3]".
struct Issue {
  std::string path;
  std::string value;     // the offending value as text
  std::string expected;  // what would have been right
  bool too_big = false;  // over a stated limit rather than malformed
  int line = 0, column = 0;  // in the scene file, 1-based; 0: not known
  long limit = 0;            // how many there may be; only where too_big
};

using Issues = std::vector<Issue>;

}  // namespace slipstitch
