// SPDX-License-Identifier: MIT
// Runs the gauntlet's cells and writes what held: see --help.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gauntlet/endurance.h"
#include "gauntlet/random_runs.h"
#include "gauntlet/run_cells.h"
#include "platform/startup.h"

namespace slipstitch::gauntlet {
namespace {

struct Options {
  std::string only, settings, out;
  std::string command;  // that chose all this, for the page
  bool plain = false;  // every case as it is, once
  bool small = false;  // without the largest case
  bool naive = false;  // and once more with each naive variant
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  int random = 0;  // scenes from seeds
  bool only_others = false;
  std::uint64_t seed = 1;
  long rest = 0;  // steps of a swatch at rest
};

constexpr double kMostDrift_m = 1e-9;

/// `cases` are those of gauntlet_cases() and the largest one.
std::vector<Cell> chosen_cells(const std::vector<GauntletCase>& cases, const Options& options) {
  const std::vector<GauntletCase> small = gauntlet_cases();
  std::vector<Cell> cells = gauntlet_cells(small);
  if (!options.small) cells.push_back({static_cast<int>(small.size()), {}});
  if (options.naive)
    for (const Cell& cell : naive_cells(small)) cells.push_back(cell);
  std::erase_if(cells, [&](const Cell& cell) {
    const bool other = !options.only.empty() && cases[static_cast<std::size_t>(cell.item)].name != options.only;
    const std::string settings = settings_text(cell.settings);
    return other || (options.plain && settings != "as it is") ||
           (!options.settings.empty() && settings != options.settings);
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

Rest run_rest(const Options& options) {
  const Rest found = rest(options.rest, [&](long done) {
    std::fprintf(stderr, "%ld/%ld steps of rest\r", done, options.rest);
  });
  std::fprintf(stderr, "\n");
  return found;
}

bool write(const std::string& folder, const std::vector<CellRow>& rows, const std::string& command,
           const std::string& more) {
  std::filesystem::create_directories(folder);
  std::ofstream text(folder + "/stability.md"), csv(folder + "/stability.csv");
  text << stability_markdown(rows, command) << more << std::flush;
  csv << stability_csv(rows) << std::flush;
  return text && csv;
}

/// What else was asked for, as a page says it.
struct Others {
  bool hold = true;
  std::string markdown;
};

Others run_others(const Options& options) {
  Others others;
  if (options.random > 0) {
    const RandomTally tally = run_seeds(options);
    std::printf("%s", random_text(tally).c_str());
    others.hold = tally.failures.empty();
    others.markdown += random_markdown(options.seed, tally);
  }
  if (options.rest > 0) {
    const Rest found = run_rest(options);
    std::printf("%s", rest_text(found).c_str());
    others.hold = others.hold && found.farthest_m < kMostDrift_m;
    others.markdown += "\n## Rest\n\n```\n" + rest_text(found) + "```\n";
  }
  return others;
}

int run_options(const Options& options) {
  if (options.only_others && options.random == 0 && options.rest == 0) {
    std::fprintf(stderr, "gauntlet: --no-cases leaves nothing to run; add --random N or --rest STEPS\n");
    return 2;
  }
  std::vector<GauntletCase> cases = gauntlet_cases();
  cases.push_back(largest_case());
  std::vector<CellRow> rows;
  if (!options.only_others) rows = run_all(cases, options);
  if (!options.only_others && rows.empty()) {
    std::fprintf(stderr, "gauntlet: no cell is of case '%s' and settings '%s'; the cases are", options.only.c_str(),
                 options.settings.c_str());
    for (const GauntletCase& item : cases) std::fprintf(stderr, " %s", item.name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  const Totals all = totals(rows);
  if (!rows.empty())
    std::printf("cells: %d pass, %d pass with steps cut, %d are refused, %d fail\n", all.passed, all.cut, all.refused,
                all.failed);
  const Others others = run_others(options);
  if (!options.out.empty() && !write(options.out, rows, options.command, others.markdown)) {
    std::fprintf(stderr, "gauntlet: cannot write %s/stability.md and stability.csv\n", options.out.c_str());
    return 1;
  }
  return all.failed == 0 && others.hold ? 0 : 1;
}

}  // namespace
}  // namespace slipstitch::gauntlet

int main(int argc, char** argv) {
  slipstitch::start_process(argv);
  using namespace slipstitch::gauntlet;
  CLI::App app{"Runs hard cases under many settings and checks what must hold in each"};
  Options options;
  app.add_option("--case", options.only, "Only this case");
  app.add_option("--settings", options.settings, "Only cells of these settings, as the output names them");
  app.add_flag("--as-is", options.plain, "Every case under its own settings only");
  app.add_flag("--naive", options.naive, "Also every case with each naive variant of the method, for comparison");
  app.add_option("--jobs", options.jobs, "Cells at a time, by default one a core")->check(CLI::PositiveNumber);
  app.add_option("--out", options.out, "Folder for stability.md and stability.csv");
  app.add_option("--random", options.random, "Also that many random scenes, one a seed")->check(CLI::PositiveNumber);
  app.add_option("--seed", options.seed, "The first seed");
  app.add_option("--rest", options.rest, "Also that many steps of a swatch at rest")->check(CLI::PositiveNumber);
  app.add_flag("--small", options.small, "Without the largest case");
  app.add_flag("--no-cases", options.only_others, "None of the cases");
  CLI11_PARSE(app, argc, argv);
  options.command = "./run gauntlet";
  for (int i = 1; i < argc; ++i) options.command += std::string(" ") + argv[i];
  return run_options(options);
}
