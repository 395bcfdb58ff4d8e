// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/issue.h"
#include "model/topology.h"

namespace slipstitch {

/// A knit as a knitter charts it: what shows on the right side (+z), course by course.
struct Pattern {
  int courses = 0;                // >= 2
  int wales = 0;                  // >= 2
  bool in_the_round = false;      // one helical yarn; flat: odd courses run -x, even +x, one yarn
  std::vector<StitchKind> cells;  // row-major, course 1 (bottom) first, wale 1 (left) first (courses * wales)

  StitchKind at(int course, int wale) const {  // 1-based
    return cells[static_cast<std::size_t>((course - 1) * wales + wale - 1)];
  }
};

/// Parses rows of K and P, top text line = last course. Appends every problem found, with paths below `path`.
Pattern pattern_from_chart(const std::vector<std::string>& rows, bool in_the_round, const std::string& path,
                           Issues& issues);

/// "stockinette" | "reverse_stockinette" | "garter" | "rib" (knits x purls) | "seed"; bad names and sizes are appended to issues.
struct PresetSpec {
  std::string name;
  int courses = 0, wales = 0;
  int rib_knits = 1, rib_purls = 1;  // only for rib, >= 1
};
Pattern pattern_from_preset(const PresetSpec& preset, bool in_the_round, const std::string& path, Issues& issues);

/// Knitter's worked rows: row r as worked, first stitch first; wrong-side rows (even rows when flat) are read from the left and swap
/// K and P. Row 1 is course 1.
Pattern pattern_from_worked_rows(const std::vector<std::string>& rows, bool in_the_round, const std::string& path,
                                 Issues& issues);

/// Smallest translational repeat (courses, wales), for the relaxation of the rest shape.
struct Repeat {
  int courses = 1, wales = 1;
};
Repeat smallest_repeat(const Pattern& pattern);

}  // namespace slipstitch
