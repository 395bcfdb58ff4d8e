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
  long least_steps = 0;  // if no step has to be cut
  std::vector<std::string> effects;
  long hessian_nonzeros = 0;           // lower triangle
  std::optional<double> memory_bytes;  // of a process that runs it, within a factor of about two
  std::optional<double> wall_s;        // of a moving scene on one core; guessed within a factor of about three
  std::string failure;                 // why there is none
};

/// Builds the model, from drawn loops because relaxing them changes no count. `scene` must be checked.
Estimate estimate(const Scene& scene);

}  // namespace slipstitch
