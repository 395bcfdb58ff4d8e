// SPDX-License-Identifier: MIT
#pragma once

#include "model/model.h"

namespace slipstitch {

/// Adds uniform noise to every coordinate of the start positions of nodes that no handle holds, the same at every call.
void add_start_noise(Model& model, double amplitude_m);

}  // namespace slipstitch
