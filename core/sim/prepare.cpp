// SPDX-License-Identifier: MIT
#include "sim/prepare.h"

#include "sim/relax.h"

namespace slipstitch {

Prepared prepare(const Scene& scene, const std::function<bool()>& should_stop) {
  Prepared prepared;
  if (!scene.knit) {
    prepared.model = compile(scene, nullptr);
    return prepared;
  }
  const Knit& knit = *scene.knit;
  RestCell cell;
  if (knit.relax_repeat && scene.effects.stretch && scene.effects.bending) {
    RelaxedRepeat relaxed = relax_repeat(knit, scene.yarn, scene.effects, kRelaxTolerance, should_stop);
    prepared.cancelled = relaxed.newton.status == NewtonStatus::cancelled;
    if (prepared.cancelled) return prepared;
    if (relaxed.newton.status != NewtonStatus::converged) {
      prepared.failure = "the knit's repeat could not be relaxed: " + std::string(to_string(relaxed.newton.status)) +
                         ", residual " + std::to_string(relaxed.residual_n) + " N";
      return prepared;
    }
    cell = std::move(relaxed.cell);
  } else {
    cell = drawn_cell(knit.pattern, knit.gauge, scene.yarn, knit.refine);
  }
  prepared.model = compile(scene, &cell);
  return prepared;
}

}  // namespace slipstitch
