// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/scene.h"

namespace slipstitch {

/// A listed effect that cannot matter in a scene, whatever happens in it.
struct IdleEffect {
  std::string effect, why;
};

/// In a scene that passed check().
std::vector<IdleEffect> idle_effects(const Scene& scene);

/// What a reader of a scene that passed check() would point out: listed effects that cannot matter in it, and effects
/// it does not list though it probably needs them. One sentence each, beginning with the effect's path. Nothing is
/// simulated.
std::vector<std::string> remarks_on(const Scene& scene);

}  // namespace slipstitch
