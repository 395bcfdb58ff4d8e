// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace slipstitch {

/// What one force term took. A term whose effect is off has none.
struct EffectCost {
  long stencils = 0;
  long bytes = 0;        // of its tables in the assembly
  long nonzeros = 0;     // lower-triangle matrix entries that it enters, each counted once
  long evaluations = 0;  // of one stencil, with or without derivatives
};

using EffectCosts = std::map<std::string, EffectCost>;  // by term

}  // namespace slipstitch
