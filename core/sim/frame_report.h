// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

namespace slipstitch {

class Simulation;

/// How a run stands at a frame. Counters are since the start; absent is not measured.
struct FrameReport {
  int frame = 0;
  double t = 0.0;  // simulated [s]
  long steps = 0, rejected_steps = 0, newton_iterations = 0, linear_iterations = 0;
  std::optional<double> step_s;    // last accepted step
  std::optional<double> residual;  // of that step; m/s, or N when quasi-static
  std::optional<double> error_estimate_m;
  /// Stored energy by potential term of the scene, and "kinetic" [J]; the same keys at every frame. None for a term
  /// that has no stencils now.
  std::map<std::string, std::optional<double>> energy_j;
};

/// For FrameReport: one evaluation of every stencil.
std::map<std::string, std::optional<double>> reported_energies(const Simulation& sim);

}  // namespace slipstitch
