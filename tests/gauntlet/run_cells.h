// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "gauntlet/gauntlet_report.h"

namespace slipstitch::gauntlet {

/// Runs cells of these cases on `jobs` threads, one cell on each; rows in the order of the cells, whichever ends first.
/// `ended` is called for one row at a time.
std::vector<CellRow> run_cells(const std::vector<GauntletCase>& cases, const std::vector<Cell>& cells, int jobs,
                               const std::function<void(const CellRow&)>& ended);

}  // namespace slipstitch::gauntlet
