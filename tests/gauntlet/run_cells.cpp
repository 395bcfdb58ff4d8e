// SPDX-License-Identifier: MIT
#include "gauntlet/run_cells.h"

#include <chrono>
#include <mutex>

#include "gauntlet/in_parallel.h"

namespace slipstitch::gauntlet {
namespace {

CellRow timed_cell(const GauntletCase& item, const Cell& cell) {
  const auto start = std::chrono::steady_clock::now();
  CellRow row{&item, cell, run_cell(item, cell.settings), 0.0};
  row.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return row;
}

}  // namespace

std::vector<CellRow> run_cells(const std::vector<GauntletCase>& cases, const std::vector<Cell>& cells, int jobs,
                               const std::function<void(const CellRow&)>& ended) {
  std::vector<CellRow> rows(cells.size());
  std::mutex one_at_a_time;
  in_parallel(cells.size(), jobs, [&](std::size_t i) {
    rows[i] = timed_cell(cases[static_cast<std::size_t>(cells[i].item)], cells[i]);
    const std::lock_guard lock(one_at_a_time);
    ended(rows[i]);
  });
  return rows;
}

}  // namespace slipstitch::gauntlet
