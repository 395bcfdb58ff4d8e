// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "study/work_precision.h"

namespace slipstitch {

/// A value that tables of a work-precision study show of every rung.
struct StudyColumn {
  const char* title;
  const char* meaning;  // a sentence
  std::string (*text)(const RungResult& result, const WorkPrecision& study);
  bool (*shown)(const WorkPrecision& study);  // null: always
  bool wide = false;                          // left out where there is little room
};

std::span<const StudyColumn> study_position_columns();  // and the time that they cost
std::span<const StudyColumn> study_other_columns();     // other errors, and what else it takes
bool is_shown(const StudyColumn& column, const WorkPrecision& study);

/// "*" of a rung on the front.
std::string front_text(const RungResult& result);

/// An error of positions.
std::string error_text(double metres);

}  // namespace slipstitch
