// SPDX-License-Identifier: MIT
#include "force/dead_load.h"

namespace slipstitch {

DeadLoad::DeadLoad(const Model& model) : node_(model.load_nodes), force_(model.load_forces) {}

}  // namespace slipstitch
