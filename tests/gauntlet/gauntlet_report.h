// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "gauntlet/gauntlet_cells.h"

namespace slipstitch::gauntlet {

struct CellRow {
  const GauntletCase* item = nullptr;
  Cell cell;
  CellResult result;
  double wall_s = 0.0;
};

/// One line of a terminal: outcome, work, worst invariant, safeguards.
std::string terminal_line(const CellRow& row);

/// Of the cells without a naive variant.
struct Totals {
  int passed = 0, cut = 0, refused = 0, failed = 0;
};
Totals totals(std::span<const CellRow> rows);

/// What is checked, one row a case, every cell that is refused or fails, and one row a naive variant. `command` made
/// it.
std::string stability_markdown(std::span<const CellRow> rows, const std::string& command);

/// One row a cell, all that was measured.
std::string stability_csv(std::span<const CellRow> rows);

}  // namespace slipstitch::gauntlet
