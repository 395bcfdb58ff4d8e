// SPDX-License-Identifier: MIT
#pragma once

#include <tuple>
#include <type_traits>

#include "force/bending.h"
#include "force/force_list.h"
#include "force/gravity.h"
#include "force/inertia.h"
#include "force/stretch.h"
#include "force/wrapping.h"

namespace slipstitch {

// Stands in for the core's list of all terms: only what the scene of swatch_run.cpp lists.
using YarnForces = std::tuple<Inertia, Gravity, Stretch, Bending, Wrapping>;
inline constexpr std::size_t kNumTerms = std::tuple_size_v<YarnForces>;
inline YarnForces make_forces(const Model& model) { return make_list<YarnForces>(model); }
template <class Term>
inline constexpr bool kIsPotential = !std::is_same_v<Term, Inertia>;

}  // namespace slipstitch
