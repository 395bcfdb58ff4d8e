// SPDX-License-Identifier: MIT
#pragma once

#include <span>
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

struct NaiveVariant {
  const char* name;
  bool Naive::*set;  // null: of the integrator, linearised Euler
};
std::span<const NaiveVariant> naive_variants();
void make_naive(const NaiveVariant& variant, Settings& settings);

/// Every case as it is, once with each naive variant.
std::vector<Cell> naive_cells(const std::vector<GauntletCase>& cases);

/// Name of the variant that is set; empty: none.
std::string naive_name(const Settings& settings);

/// "step x0.01, stiffness x1000, static, simplicial"; "as it is".
std::string settings_text(const Settings& settings);

}  // namespace slipstitch::gauntlet
