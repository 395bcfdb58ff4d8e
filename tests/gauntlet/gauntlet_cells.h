// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "gauntlet/gauntlet_case.h"

namespace slipstitch::gauntlet {

/// A case under settings that pairwise_covering() chose.
struct Cell {
  int item = 0;  // into the cases
  Settings settings;
};

/// Every two of case, step, stiffness, inertia and solver together at least once, and every case as it is first.
std::vector<Cell> gauntlet_cells(const std::vector<GauntletCase>& cases);

/// "step x0.01, stiffness x1000, static, simplicial"; "as it is".
std::string settings_text(const Settings& settings);

}  // namespace slipstitch::gauntlet
