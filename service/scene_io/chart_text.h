// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "slipstitch/v1/scene.pb.h"

namespace slipstitch {

/// Rows of a chart file and the lines they stood on (1-based). Empty lines and lines starting with # are left out.
struct ChartText {
  std::vector<std::string> rows;
  std::vector<int> lines;
};
ChartText split_chart(std::string_view text);

/// What a bare chart is run as: the demo. A worsted acrylic fabric lies horizontally, held at its two top corners, and
/// falls under gravity for 2 s, with every effect on.
v1::Scene scene_for_chart(const std::vector<std::string>& rows, const std::string& name);

}  // namespace slipstitch
