// SPDX-License-Identifier: MIT
#include "force/gap_energy.h"

#include <cmath>
#include <limits>

namespace slipstitch {

GapEnergy gap_energy(double k, double w, double gap) {
  if (gap >= 0.0) return {};
  const double r = 1.0 + gap / w;
  if (!(r > 0.0)) return {std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const double ln = std::log(r), m = r - 1.0;
  return {-k * w * m * m * ln, -k * (2.0 * m * ln + m * m / r), -k / w * (2.0 * ln + 4.0 * m / r - m * m / (r * r))};
}

}  // namespace slipstitch
