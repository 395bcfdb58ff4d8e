// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene.h"

namespace slipstitch {

/// One side of a comparison: a scene with an effect, or without it.
struct EffectSide {
  double wall_s = 0.0;  // median of the rounds
  double memory_bytes = 0.0;
  long dofs = 0, nonzeros = 0, steps = 0, newton_iterations = 0, factorizations = 0, cg_iterations = 0;
  double stored_j = 0.0, tension_n = 0.0, reaction_n = 0.0;  // as in MeasuredRun
};

/// What one effect changes, and what it costs.
struct EffectPrice {
  std::string effect;
  bool listed = false;                // by the scene; otherwise it was added with default parameters
  std::vector<std::string> together;  // listed effects that go with it, because they need it
  std::string not_compared;           // why there is no comparison; empty: there is one
  double max_displacement_m = 0.0;    // between with and without, of any node at any frame
  double rms_displacement_m = 0.0;    // over nodes and frames
  double time_ratio = 0.0;            // with / without: median of the ratios of runs made one after the other
  EffectSide with, without;
};

struct EffectStudy {
  std::string scene;
  std::string failure;  // why there is no study: the scene itself does not run
  double radius_m = 0.0, duration_s = 0.0;
  int rounds = 0, loops = 0, frames = 0;
  bool stopped = false;     // before all rounds were done; the prices are those of the whole rounds
  bool repeatable = false;  // all runs of the scene itself ended in the same state, bit for bit
  EffectSide itself;
  std::vector<EffectPrice> prices;  // in the order of effect_list(); all that could be in the scene, or why not
};

struct StudyOptions {
  int rounds = 3, threads = 1;
  long effort_factor = 8, least_effort = 1000;  // a variant is given up after factor * the scene's iterations + least
  std::function<void(double share, const std::string& what)> on_progress;  // may be empty
  std::function<bool()> should_stop;                                       // may be empty
};

/// Runs a checked scene with and without every effect that could be in it. Every round runs all variants, two by two
/// behind a run of the scene itself to which their times are compared, so that a machine that gets slower or faster
/// on the way moves both. The memory reported is the least of all rounds: the first runs of a process also take what
/// stays for all.
EffectStudy study_effects(const Scene& scene, const StudyOptions& options);

}  // namespace slipstitch
