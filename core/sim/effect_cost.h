// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace slipstitch {

/// What one force term took, or an effect that acts in the stencils of others: plasticity in those of bending, shrinkage
/// of stretch, wind of air_drag. Sliding has unknowns and the entries of the matrix in their rows and columns. What is off
/// has none.
struct EffectCost {
  long dofs = 0;         // unknowns that are there for it alone
  long stencils = 0;
  long bytes = 0;        // of its tables in the assembly, and of what it searches for stencils in
  long nonzeros = 0;     // lower-triangle matrix entries that it enters, each counted once
  long evaluations = 0;  // of one stencil, with or without derivatives
  long searches = 0;     // for stencils, among all that could be one
};

using EffectCosts = std::map<std::string, EffectCost>;  // by term or effect

}  // namespace slipstitch
