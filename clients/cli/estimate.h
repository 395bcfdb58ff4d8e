// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene.h"

namespace slipstitch {

/// What a scene takes, without running it.
struct Estimate {
  int loops = 0, nodes = 0, dofs = 0;
  int frames = 0;
  std::optional<long> least_steps;  // if no step has to be cut; not known where the run chooses them
  std::vector<std::string> effects;
  long hessian_nonzeros = 0;           // lower triangle
  std::optional<double> memory_bytes;  // of a process that runs it, within a factor of about two
  std::optional<double> wall_s;        // of a moving scene with fixed steps on one core, within a factor of about three
  std::string failure;                 // why there is none
};

/// Builds the model, from drawn loops because relaxing them changes no count. `scene` must be checked.
Estimate estimate(const Scene& scene);

}  // namespace slipstitch
