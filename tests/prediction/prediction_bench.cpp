// SPDX-License-Identifier: MIT
// What runs were predicted to take, beside what they took; for ./run bench.
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "platform/startup.h"
#include "prediction/calibration_cache.h"
#include "sim/run.h"
#include "study/prediction.h"
#include "study/varied_scenes.h"

namespace slipstitch::testing {
namespace {

constexpr double kFactor = 2.0;

struct Tally {
  int good = 0, all = 0;
};

void compare(const std::string& what, double predicted_s, const RunSummary& ran, Tally& tally) {
  const double ratio = predicted_s / ran.wall_s;
  const bool good = std::max(ratio, 1.0 / ratio) <= kFactor;
  tally.good += good ? 1 : 0;
  ++tally.all;
  std::cout << "  " << std::left << std::setw(30) << what << std::right << std::fixed << std::setprecision(2)
            << std::setw(10) << predicted_s << " s" << std::setw(10) << ran.wall_s << " s" << std::setw(8) << ratio
            << (good ? "" : "  <-") << std::endl;
}

void print(const char* what, const Tally& tally) {
  std::cout << what << ": " << tally.good << " of " << tally.all << " within a factor of " << kFactor << std::endl;
}

int bench() {
  Tally as_it_is, to_tolerance;
  int n = 0;
  std::cout << "predicted and taken by a run" << std::endl;
  for (const Scene& scene : varied_scenes()) {
    PredictOptions options;
    options.calibration = &machine_calibration();
    const Prediction found = predict(scene, options);
    const std::string name = std::to_string(++n) + " " + scene.name;
    if (found.as_it_is) compare(name, found.as_it_is->wall_s, run(scene, 1, {}), as_it_is);
    if (std::holds_alternative<AccuracyNumerics>(scene.numerics) || found.to_tolerance.empty()) continue;
    const TolerancePrediction& coarse = found.to_tolerance.front();
    compare(name + " to 1 mm", coarse.run.wall_s, run(to(scene, coarse.tolerance_m), 1, {}), to_tolerance);
  }
  print("as they are", as_it_is);
  print("to 1 mm", to_tolerance);
  return 0;
}

}  // namespace
}  // namespace slipstitch::testing

int main(int, char** argv) {
  slipstitch::start_process(argv);
  return slipstitch::testing::bench();
}
