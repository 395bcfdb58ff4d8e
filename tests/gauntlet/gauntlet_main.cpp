// SPDX-License-Identifier: MIT
// Runs the gauntlet's cells and writes what held: see --help.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gauntlet/random_runs.h"
#include "gauntlet/run_cells.h"
#include "platform/startup.h"

namespace slipstitch::gauntlet {
namespace {

struct Options {
  std::string only, out;
  bool plain = false;  // every case as it is, once
  bool naive = false;  // and once more with each naive variant
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  int random = 0;  // scenes from seeds
  bool only_random = false;
  std::uint64_t seed = 1;
};

std::vector<Cell> chosen_cells(const std::vector<GauntletCase>& cases, const Options& options) {
  std::vector<Cell> cells = gauntlet_cells(cases);
  if (options.naive)
    for (const Cell& cell : naive_cells(cases)) cells.push_back(cell);
  std::erase_if(cells, [&](const Cell& cell) {
    const bool other = !options.only.empty() && cases[static_cast<std::size_t>(cell.item)].name != options.only;
    return other || (options.plain && settings_text(cell.settings) != "as it is");
  });
  return cells;
}

std::vector<CellRow> run_all(const std::vector<GauntletCase>& cases, const Options& options) {
  const std::vector<Cell> cells = chosen_cells(cases, options);
  std::size_t done = 0;
  return run_cells(cases, cells, options.jobs, [&](const CellRow& row) {
    std::fprintf(stderr, "%zu/%zu %s\n", ++done, cells.size(), terminal_line(row).c_str());
  });
}

RandomTally run_seeds(const Options& options) {
  int done = 0;
  return run_random(options.seed, options.random, options.jobs,
                    [&](const GauntletCase& item, const CellResult& result, double wall_s) {
                      const CellRow row{&item, {}, result, wall_s};
                      std::fprintf(stderr, "%d/%d %s  %s\n", ++done, options.random, terminal_line(row).c_str(),
                                   item.about.c_str());
                    });
}

bool write(const std::string& folder, const std::vector<CellRow>& rows, const std::string& random) {
  std::filesystem::create_directories(folder);
  std::ofstream text(folder + "/stability.md"), csv(folder + "/stability.csv");
  text << stability_markdown(rows) << random << std::flush;
  csv << stability_csv(rows) << std::flush;
  return text && csv;
}

int run_options(const Options& options) {
  const std::vector<GauntletCase> cases = gauntlet_cases();
  std::vector<CellRow> rows;
  if (!options.only_random) rows = run_all(cases, options);
  if (!options.only_random && rows.empty()) {
    std::fprintf(stderr, "gauntlet: there is no case '%s'; the cases are", options.only.c_str());
    for (const GauntletCase& item : cases) std::fprintf(stderr, " %s", item.name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  RandomTally tally;
  if (options.random > 0) tally = run_seeds(options);
  if (!options.out.empty() &&
      !write(options.out, rows, options.random > 0 ? random_markdown(options.seed, tally) : "")) {
    std::fprintf(stderr, "gauntlet: cannot write %s/stability.md and stability.csv\n", options.out.c_str());
    return 1;
  }
  const Totals all = totals(rows);
  if (!rows.empty())
    std::printf("cells: %d pass, %d pass with steps cut, %d are refused, %d fail\n", all.passed, all.cut, all.refused,
                all.failed);
  if (options.random > 0) std::printf("%s", random_text(tally).c_str());
  return all.failed == 0 && tally.failures.empty() ? 0 : 1;
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
  app.add_flag("--naive", options.naive, "Also every case with each naive variant of the method, for comparison");
  app.add_option("--jobs", options.jobs, "Cells at a time, by default one a core")->check(CLI::PositiveNumber);
  app.add_option("--out", options.out, "Folder for stability.md and stability.csv");
  auto* random = app.add_option("--random", options.random, "Also that many random scenes, one a seed");
  random->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "The first seed");
  app.add_flag("--only-random", options.only_random, "None of the cases")->needs(random);
  CLI11_PARSE(app, argc, argv);
  return run_options(options);
}
