// SPDX-License-Identifier: MIT
// Wall time asked of runs and taken by them, with what it was good for; for ./run bench.
#include <iomanip>
#include <iostream>
#include <string>

#include "platform/startup.h"
#include "scene_io/load_scene.h"
#include "sim/run.h"

namespace slipstitch {
namespace {

constexpr double kTolerance_m = 1e-4;  // whose time the budgets are shares of

Scene accuracy_scene(const std::string& name) {
  LoadResult loaded = load_scene_file(std::string(SLIPSTITCH_SOURCE_DIR "/scenes/accuracy/") + name + ".json");
  return std::get<LoadedScene>(loaded).scene;
}

double micrometres(const RunSummary& ran) { return 1e6 * ran.error_estimate_m.value_or(0.0); }

void compare(const std::string& name) {
  Scene scene = accuracy_scene(name);
  scene.numerics = AccuracyNumerics{kTolerance_m};
  const RunSummary known = run(scene, 1, {});
  std::cout << "  " << std::left << std::setw(12) << name << std::right << std::fixed << std::setprecision(2)
            << "to 0.1 mm" << std::setw(11) << known.wall_s << " s" << std::setw(21) << micrometres(known) << " um"
            << std::endl;
  for (const double share : {1.0 / 3.0, 1.0, 3.0}) {
    scene.numerics = BudgetNumerics{share * known.wall_s};
    const RunSummary ran = run(scene, 1, {});
    const BudgetReport& budget = *ran.budget;
    std::cout << "  " << std::setw(19) << budget.budget_s << " s" << std::setw(11) << ran.wall_s << " s" << std::setw(8)
              << ran.wall_s / budget.budget_s << std::setw(13) << micrometres(ran) << " um, as to "
              << std::setprecision(4) << 1e3 * budget.same_tolerance_m.value_or(0.0) << std::setprecision(2) << " mm"
              << (budget.kept ? "" : ", not kept") << std::endl;
  }
}

int bench() {
  std::cout << "budget of wall time, taken, taken by asked, the run's estimate of its error" << std::endl;
  for (const char* name : {"drape", "curl", "ball-drop"}) compare(name);
  return 0;
}

}  // namespace
}  // namespace slipstitch

int main(int, char** argv) {
  slipstitch::start_process(argv);
  return slipstitch::bench();
}
