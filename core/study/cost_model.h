// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "solve/linear_solver.h"

namespace slipstitch {

/// What one Newton iteration works on.
struct ProblemSize {
  int dofs = 0;
  double nonzeros = 0.0;  // of the Hessian's lower triangle
  FactorSize factor;
};

/// Iterations that were timed, all of them of one size.
struct TimedIterations {
  ProblemSize size;
  double iterations = 0.0, wall_s = 0.0;
  double factor_s = 0.0;  // of wall_s, in factorisations
};

/// Wall time of a Newton iteration: what goes with the entries of the Hessian (assembly, energies, line search, solves)
/// and what goes with the factor's operations.
struct IterationCost {
  double per_nonzero_s = 0.0, per_operation_s = 0.0;
};

double iteration_s(const IterationCost& cost, const ProblemSize& size);

/// Operations cost what they do in the largest factor, as small ones spend their time on other things; entries the mean
/// of what is left. Samples without iterations do not count.
IterationCost fit_cost(std::span<const TimedIterations> timed);

/// What the factor of a sheet of `dofs` unknowns takes, by one that is known: with nested dissection its entries grow
/// like n log n and its operations like n^1.5 [George 1973].
FactorSize scaled_factor(const ProblemSize& known, int dofs);

/// How far a run was when it had made so many iterations.
struct RunPoint {
  double t = 0.0;  // simulated [s]
  double steps = 0.0, iterations = 0.0;
};

/// Points of one run from its start on, times ascending.
using RunCourse = std::vector<RunPoint>;

/// Counts at the end of a run that has come to the last point of `begun`. Two guesses: that it goes on as in the last
/// half of the time so far, and that it takes from here on as much more or less than `model`, the course of another
/// run, as up to here, if that is more than its first step. The result lies between them, the nearer to the first the
/// larger the share of the duration that is done; runs begin with settling that says little of the rest. Without points
/// it takes what the model takes.
RunPoint extrapolate(const RunCourse& begun, double duration_s, const RunCourse& model);

/// The same with a guess of the counts at the end in place of the model.
RunPoint extrapolate(const RunCourse& begun, double duration_s, const RunPoint& guess);

/// Counts of a run to a tolerance, from those of one to another tolerance: as a method of second order takes steps.
RunPoint at_tolerance(const RunPoint& known, double known_tolerance_m, double tolerance_m);

/// Counts of `course` at time t, linear between its points, and beyond them as in its last half.
RunPoint counts_at(const RunCourse& course, double t);

}  // namespace slipstitch
