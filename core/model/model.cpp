// SPDX-License-Identifier: MIT
#include "model/model.h"

namespace slipstitch {

double rest_length(const Topology& topology, int segment) {
  const auto i = static_cast<std::size_t>(segment);
  return topology.rest_arc[i + 1] - topology.rest_arc[i];
}

double linear_density(const Model& model, int yarn) {
  return model.yarn.linear_density_kg_per_m * model.topology.density_scale[static_cast<std::size_t>(yarn)];
}

}  // namespace slipstitch
