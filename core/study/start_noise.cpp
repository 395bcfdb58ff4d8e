// SPDX-License-Identifier: MIT
#include "study/start_noise.h"

#include <random>

#include "sim/dof_map.h"

namespace slipstitch {

void add_start_noise(Model& model, double amplitude_m) {
  constexpr std::uint64_t kSeed = 1;
  constexpr double kUnit = 0x1p-53;
  std::mt19937_64 bits(kSeed);
  const DofMap map = make_dof_map(model);
  for (int c = 0; c < 3 * model.topology.num_nodes; ++c) {
    if (map.dof_of(c) < 0) continue;
    const double in_0_1 = static_cast<double>(bits() >> 11) * kUnit;
    model.start_q[c] += amplitude_m * (2.0 * in_0_1 - 1.0);
  }
}

}  // namespace slipstitch
