// SPDX-License-Identifier: MIT
#include "cli/estimate.h"

#include <cmath>

#include "model/effect_list.h"
#include "platform/memory.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/simulation.h"
#include "study/choose_effects.h"

namespace slipstitch {
namespace {

// A fabric's nested-dissection factor grows like n log n; the constant comes from two scenes, of 36 and 1,600 loops.
double factor_bytes(double n) {
  constexpr double kNonzerosPerDof = 20.0;
  return n > 1.0 ? 8.0 * kNonzerosPerDof * n * std::log2(n) : 0.0;
}

// A step is a few Newton iterations, most of whose time goes into factoring: like n log n at these sizes. Measured with
// `simulate scenes/stockinette-drape.json --json --threads 1` on one 2.3 GHz core, in us a step over n log2 n: the
// chart cut to 10x10, 20x20 and 40x40 stitches and run for 0.2 s, 1.9, 1.8 and 2.3; the whole scene 1.1;
// small-swing.json 2.1.
double step_s(double n) {
  constexpr double kSeconds = 1.6e-6;
  return n > 1.0 ? kSeconds * n * std::log2(n) : 0.0;
}

}  // namespace

Estimate estimate(const Scene& given) {
  Estimate estimate;
  const Scene scene = with_candidates(given);
  estimate.effects = effect_names(scene.effects);
  estimate.frames = planned_frames(scene.duration_s, scene.frames_per_s);
  if (const auto* numerics = std::get_if<FixedNumerics>(&scene.numerics)) {
    estimate.least_steps = least_steps(scene.duration_s, scene.frames_per_s, numerics->time_step_s);
  }
  Scene drawn = scene;
  if (drawn.knit) drawn.knit->relax_repeat = false;
  Prepared prepared = prepare(drawn);
  if (prepared.failure) {
    estimate.failure = *prepared.failure;
    return estimate;
  }
  const Simulation simulation(std::move(prepared.model));
  estimate.loops = static_cast<int>(simulation.model().topology.stitches.size());
  estimate.nodes = simulation.model().topology.num_nodes;
  estimate.dofs = simulation.num_dofs();
  estimate.hessian_nonzeros = simulation.num_nonzeros();
  if (const auto built = peak_memory_bytes()) {
    const int factors = std::holds_alternative<AccuracyNumerics>(scene.numerics) ? 2 : 1;  // the companion's too
    estimate.memory_bytes = static_cast<double>(*built) + factors * factor_bytes(estimate.dofs);
  }
  // A static scene is one solve, of as many iterations as it takes.
  if (scene.effects.inertia && estimate.least_steps)
    estimate.wall_s = static_cast<double>(*estimate.least_steps) * step_s(estimate.dofs);
  return estimate;
}

}  // namespace slipstitch
