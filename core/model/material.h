// SPDX-License-Identifier: MIT
#pragma once

namespace slipstitch {

/// One yarn. The defaults are a worsted acrylic: EI from Singal et al., Nat. Commun. 15, 2622 (2024);
/// EA, linear density and radius from Ding et al., arXiv 2307.12360.
struct YarnMaterial {
  double radius_m = 0.524e-3;             // R > 0
  double linear_density_kg_per_m = 0.077e-3;  // rho of the real yarn > 0
  double stretch_n = 68.0;                // k_s = EA > 0
  double bending_nm2 = 4.5e-8;            // k_b = EI > 0
};

}  // namespace slipstitch
