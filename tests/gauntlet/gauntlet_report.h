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

/// What is checked, one row a case, and every cell that did not pass as it should.
std::string stability_markdown(std::span<const CellRow> rows, const std::string& command);

/// One row a cell, all that was measured.
std::string stability_csv(std::span<const CellRow> rows);

}  // namespace slipstitch::gauntlet
