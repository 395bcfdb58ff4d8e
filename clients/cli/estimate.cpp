// SPDX-License-Identifier: MIT
#include "cli/estimate.h"

#include <cmath>

#include "platform/memory.h"
#include "sim/prepare.h"
#include "sim/run.h"
#include "sim/simulation.h"

namespace slipstitch {
namespace {

long least_steps(const Scene& scene, int frames) {
  const auto* numerics = std::get_if<FixedNumerics>(&scene.numerics);
  if (numerics == nullptr) return 0;
  const double a_frame = std::ceil(1.0 / (scene.frames_per_s * numerics->time_step_s) - 1e-9);
  return static_cast<long>(a_frame) * (frames - 1);
}

// A fabric's nested-dissection factor grows like n log n; the constant comes from two scenes, of 36 and 1,600 loops.
double factor_bytes(double n) {
  constexpr double kNonzerosPerDof = 20.0;
  return n > 1.0 ? 8.0 * kNonzerosPerDof * n * std::log2(n) : 0.0;
}

}  // namespace

Estimate estimate(const Scene& scene) {
  Estimate estimate;
  estimate.effects = effect_names(scene.effects);
  estimate.frames = planned_frames(scene.duration_s, scene.frames_per_s);
  estimate.least_steps = least_steps(scene, estimate.frames);
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
    estimate.memory_bytes = static_cast<double>(*built) + factor_bytes(estimate.dofs);
  }
  return estimate;
}

}  // namespace slipstitch
