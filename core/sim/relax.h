// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>

#include "model/knit_repeat.h"
#include "solve/newton.h"

namespace slipstitch {

inline constexpr double kRelaxTolerance = 1e-7;

struct RelaxedRepeat {
  RestCell cell;       // of the last iterate, whether or not it converged
  NewtonReport newton;
  double residual_n = 0.0;  // max |gradient| [N]
  std::map<std::string, double> energies_j;  // of one repeat, by term; stored_energy.h
};

/// The rest shape of an endless knit: one repeat, from the drawn loops, by Newton's method to a force residual of
/// `relative_tolerance` EI/L^2 (L the contact's rest length). Unknowns: the repeat's nodes and the period vectors
/// (a_x, 0, 0), (b_x, b_y, 0). Arc lengths are held as drawn: friction keeps the proportions of a knit's loops, and
/// yarn free to slide would empty its legs or heads down to contact between neighbouring contacts. Gravity, inertia
/// and damping stay out. should_stop is polled every iteration; may be empty.
RelaxedRepeat relax_repeat(const Knit& knit, const YarnMaterial& yarn, const Effects& effects,
                           double relative_tolerance = kRelaxTolerance, const std::function<bool()>& should_stop = {});

}  // namespace slipstitch
