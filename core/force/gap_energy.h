// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// Contact of hard yarn: V = -k w (r - 1)^2 ln r with r = 1 + gap/w, for -w < gap < 0; else 0; infinite at gap <= -w.
/// C2. k [N], w > 0 the deepest overlap [m]; returns V, dV/dgap and d2V/dgap2.
struct GapEnergy {
  double value = 0.0, slope = 0.0, curvature = 0.0;
};
GapEnergy gap_energy(double k, double w, double gap);

}  // namespace slipstitch
