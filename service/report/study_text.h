// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "study/work_precision.h"

namespace slipstitch {

/// Why rungs have no result, one sentence a reason, with their names.
std::vector<std::string> without_result(const WorkPrecision& study);

/// One sentence or two each, for below the tables.
std::string about_study(const WorkPrecision& study);
std::string about_reference(const WorkPrecision& study);
std::string about_horizon(const WorkPrecision& study);
std::string about_worst_place(const WorkPrecision& study);
std::string about_digits(const WorkPrecision& study);
std::string how_to_read_study();

}  // namespace slipstitch
