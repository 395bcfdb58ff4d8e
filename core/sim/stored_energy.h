// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>

#include "force/yarn_forces.h"
#include "model/state.h"

namespace slipstitch {

/// Of each term, in the order of YarnForces [J].
using TermEnergies = std::array<double, kNumTerms>;

/// At coordinates q (num_coords). Counts nothing and changes nothing that a later step could see, unlike
/// Assembly::value().
TermEnergies term_energies(const YarnForces& forces, const VecX& q);

/// Stored energy by potential term that has stencils, and "kinetic" of a scene with inertia [J]; of wrapping, that
/// above every wrap at rest.
std::map<std::string, double> stored_energies(const YarnForces& forces, const State& state,
                                              const TermEnergies& energies);

}  // namespace slipstitch
