// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "model/model.h"

namespace slipstitch {

struct Prepared {
  Model model;
  std::optional<std::string> failure;  // why there is no model
  bool cancelled = false;              // there is none because should_stop said so
};

/// From a checked scene to a model: relaxes the knit's repeat if the scene asks for it, tiles and places it.
/// should_stop is polled every iteration of the relaxation; may be empty.
Prepared prepare(const Scene& scene, const std::function<bool()>& should_stop = {});

}  // namespace slipstitch
