// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "study/work_precision.h"

namespace slipstitch {

/// Two tables of at most 80 columns, what every rung gives and what it takes, and what is to be said of them.
std::string study_table(const WorkPrecision& study);

}  // namespace slipstitch
