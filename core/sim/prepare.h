// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "model/model.h"

namespace slipstitch {

struct Prepared {
  Model model;
  std::optional<std::string> failure;  // why there is no model
};

/// From a checked scene to a model: relaxes the knit's repeat if the scene asks for it, tiles and places it.
Prepared prepare(const Scene& scene);

}  // namespace slipstitch
