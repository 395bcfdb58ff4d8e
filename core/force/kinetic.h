// SPDX-License-Identifier: MIT
#pragma once

#include "math/types.h"

namespace slipstitch {

/// Kinetic energy of one segment whose material point velocity xdot_i - w udot_i, w = (x1 - x0)/D, D = u1 - u0, runs
/// linearly between its ends: T = 1/2 qdot^T M(q) qdot; rho linear density [kg/m]. Order x0, u0, x1, u1.
/// M has rank 6: sliding a node along its own segment moves no material.
/// [Sueda et al. 2011; Cirio et al. 2014]
double kinetic_energy(double rho, const Vec<8>& q, const Vec<8>& qdot);
Mat<8> kinetic_mass(double rho, const Vec<8>& q);
Vec<8> kinetic_gradient(double rho, const Vec<8>& q, const Vec<8>& qdot);   // dT/dq at fixed qdot
Vec<8> kinetic_mass_rate(double rho, const Vec<8>& q, const Vec<8>& qdot);  // (dM/dt) qdot along qdot

}  // namespace slipstitch
