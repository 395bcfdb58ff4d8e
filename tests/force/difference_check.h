// SPDX-License-Identifier: MIT
#pragma once

#include "evaluation.h"

namespace slipstitch::testing {

/// Checks the gradient against central differences of the energy and the Hessian against those of the gradient, at
/// steps h0 2^-k. A right derivative leaves C h^order and the rounding of the differenced values, so every error must
/// lie below twice that line through the first four steps plus noise/h. A wrong one leaves its own error where that
/// bound is smallest. Rounding of a value is taken as four units in its last place and in those of the coordinates it
/// is computed from, times their number.
void expect_exact_derivatives(const VecX& q, double h0, int order, const Energy& energy);

}  // namespace slipstitch::testing
