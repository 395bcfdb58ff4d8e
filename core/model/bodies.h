// SPDX-License-Identifier: MIT
#pragma once

#include "model/model.h"

namespace slipstitch {

/// Appends the dynamic spheres of model.effects: their nodes behind all others, places, velocities, and model.bodies.
void append_bodies(Model& model);

}  // namespace slipstitch
