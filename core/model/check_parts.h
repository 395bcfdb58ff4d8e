// SPDX-License-Identifier: MIT
#pragma once

#include "model/check_values.h"
#include "model/scene.h"

namespace slipstitch {

// The parts of check(Scene), each with the paths of its part of the schema.
void check_effects(const Effects& effects, Checker& check);
void check_colliders(const CollidersEffect& effect, bool inertia, Checker& check);
void check_motion(const std::vector<Keyframe>& motion, const std::string& path, Checker& check);
void check_knit(const Knit& knit, const SceneLimits& limits, Checker& check);
void check_yarns(const Scene& scene, const SceneLimits& limits, Checker& check);
void check_actions(const Scene& scene, Checker& check);  // handles, loads, initial velocities
void check_numerics(const Scene& scene, const SceneLimits& limits, Checker& check);

}  // namespace slipstitch
