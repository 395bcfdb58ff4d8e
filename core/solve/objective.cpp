// SPDX-License-Identifier: MIT
#include "solve/objective.h"

namespace slipstitch {

void Objective::predict(const VecX&, const VecX&) {}
void Objective::settle(VecX&, const VecX&) {}
double Objective::step_size(const VecX& dx) const { return dx.size() > 0 ? dx.cwiseAbs().maxCoeff() : 0.0; }

}  // namespace slipstitch
