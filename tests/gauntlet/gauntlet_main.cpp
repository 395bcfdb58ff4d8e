// SPDX-License-Identifier: MIT
// Runs the gauntlet's cells and writes what held: see --help.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "gauntlet/gauntlet_report.h"
#include "gauntlet/random_runs.h"
#include "platform/startup.h"

namespace slipstitch::gauntlet {
namespace {

struct Options {
  std::string only, out;
  bool plain = false;  // every case as it is, once
  int random = 0;      // scenes from seeds, in place of the cases
  std::uint64_t seed = 1;
};

std::vector<CellRow> run_all(const std::vector<GauntletCase>& cases, const Options& options) {
  std::vector<CellRow> rows;
  const std::vector<Cell> cells = gauntlet_cells(cases);
  std::size_t done = 0;
  for (const Cell& cell : cells) {
    ++done;
    const GauntletCase& item = cases[static_cast<std::size_t>(cell.item)];
    if (!options.only.empty() && item.name != options.only) continue;
    if (options.plain && settings_text(cell.settings) != "as it is") continue;
    const auto start = std::chrono::steady_clock::now();
    CellRow row{&item, cell, run_cell(item, cell.settings), 0.0};
    row.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::fprintf(stderr, "%zu/%zu %s\n", done, cells.size(), terminal_line(row).c_str());
    rows.push_back(std::move(row));
  }
  return rows;
}

int write(const std::string& folder, const std::vector<CellRow>& rows) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/stability.md") << stability_markdown(rows, "./run gauntlet");
  std::ofstream csv(folder + "/stability.csv");
  csv << stability_csv(rows) << std::flush;
  return csv ? 0 : 1;
}

int run_seeds(const Options& options) {
  int done = 0;
  const RandomTally tally =
      run_random(options.seed, options.random, [&](const GauntletCase& item, const CellResult& result, double wall_s) {
        const CellRow row{&item, {}, result, wall_s};
        std::fprintf(stderr, "%d/%d %s  %s\n", ++done, options.random, terminal_line(row).c_str(), item.about.c_str());
      });
  for (const auto& failure : tally.failures)
    std::printf("seed %llu: %s (%s)\n", static_cast<unsigned long long>(failure.seed), failure.why.c_str(),
                failure.about.c_str());
  std::printf("%d passed, %d cut, %d refused, %d failed\n", tally.count(Outcome::passed), tally.count(Outcome::cut),
              tally.count(Outcome::refused), tally.count(Outcome::failed));
  return tally.failures.empty() ? 0 : 1;
}

}  // namespace
}  // namespace slipstitch::gauntlet

int main(int argc, char** argv) {
  slipstitch::start_process(argv);
  using namespace slipstitch::gauntlet;
  CLI::App app{"Runs hard cases under many settings and checks what must hold in each"};
  Options options;
  app.add_option("--case", options.only, "Only this case");
  app.add_flag("--as-is", options.plain, "Every case under its own settings only");
  app.add_option("--out", options.out, "Folder for stability.md and stability.csv");
  app.add_option("--random", options.random, "That many random scenes instead, one a seed")->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "The first seed");
  CLI11_PARSE(app, argc, argv);
  if (options.random > 0) return run_seeds(options);
  const std::vector<GauntletCase> cases = gauntlet_cases();
  const std::vector<CellRow> rows = run_all(cases, options);
  if (rows.empty()) {
    std::fprintf(stderr, "gauntlet: there is no case '%s'\n", options.only.c_str());
    return 2;
  }
  if (!options.out.empty() && write(options.out, rows) != 0) return 1;
  for (const CellRow& row : rows)
    if (row.result.outcome == Outcome::failed) return 1;
  return 0;
}
