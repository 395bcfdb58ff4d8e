// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/run_shelf.h"
#include "study/rungs.h"

namespace slipstitch {

/// How far a run is from the reference. Positions up to the horizon, NaN where that leaves nothing to compare.
struct RungErrors {
  double position_m = 0.0;                               // of any node at any frame
  double most_m = 0.0;                                   // that 95 of 100 nodes keep to at any frame
  double rms_m = 0.0;                                    // root mean square over nodes and frames
  double stored_j = 0.0, force_n = 0.0, length_m = 0.0;  // of what FrameTrace has, at any frame of the run
};

/// Time of the baseline to the same error / that of the rung.
struct Speedup {
  double factor = 0.0;
  bool extrapolated = false;  // the baseline's time, beyond what was run of it
};

/// One way to run the scene, what it costs and what it gives.
struct RungResult {
  Rung rung;
  std::string no_result;  // why there is none; empty: there is one
  bool failed = false;    // the run itself; otherwise it was not run
  int times = 0;          // that it was run
  double wall_s = 0.0;    // the median
  double memory_bytes = 0.0;
  long steps = 0, rejected_steps = 0, newton_iterations = 0, factorizations = 0, cg_iterations = 0;
  std::optional<double> error_estimate_m;  // the run's own
  std::optional<RungErrors> errors;        // none without a reference
  std::optional<double> order;  // power of the step, or tolerance, that errors fell with since the rung before
  bool resolved = false;        // the error is more than three times the reference's own, and predictable
  std::optional<double> predictable_until_s;     // to its own error; none: to the end
  std::optional<Speedup> speedup, speedup_most;  // to the same position_m, and most_m; none: not known
  bool on_front = false;                         // no other one is both faster and more accurate
};

/// What the others are compared to: the scene with ever shorter steps and tighter solves, until that changes nothing.
struct StudyReference {
  std::string method;
  std::string failure;  // why there is none; empty: there is one
  double step_s = 0.0, wall_s = 0.0;
  int refinements = 0;                // runs beyond the finest rung
  std::vector<double> change_m;       // of positions up to the horizon, from one refinement to the next
  std::optional<double> order;        // of the last two changes
  std::optional<double> error_m;      // its own
  bool extrapolated = false;          // what is left by that order, where it fits; otherwise error_m is the last change
  bool settled = false;               // the last change is below a tenth of every rung's error
  bool at_noise = false;              // the last change is no larger than what the twin's noise makes
  bool out_of_time = false;           // before it settled
  std::optional<double> twin_step_s;  // of the run with noise; none: nothing is known of the horizon
  double twin_distance_m = 0.0;       // largest, of the two runs at any frame
};

/// Along the front.
struct DigitPrice {
  double from_m = 0.0, to_m = 0.0;  // a tenth of from_m
  double time_factor = 0.0;
};

struct WorkPrecision {
  std::string scene;
  std::string failure;  // why there is no study
  double radius_m = 0.0, duration_s = 0.0;
  int loops = 0, dofs = 0, frames = 0, threads = 1;
  bool quick = false, stopped = false;  // stopped: when asked to; what was run is on the shelf
  std::vector<RungResult> rungs;        // method by method, coarse to fine
  StudyReference reference;
  std::string worst_place;          // where most rungs have their largest error
  int at_worst_place = 0;           // so many
  std::optional<double> horizon_s;  // from here on positions are not compared; none: they are to the end
  double stored_j = 0.0, force_n = 0.0, length_m = 0.0;  // largest of the reference at any frame, to set errors against
  std::vector<DigitPrice> digits;
  std::optional<double> digit_factor;  // mean over the whole front of the time for ten times less error
};

struct WorkPrecisionOptions {
  bool quick = false;
  int threads = 1;
  double budget_s = 0.0;            // of wall time for all that is run; 0: no end
  double short_run_s = 2.0;         // rungs that take less are run three times, in turn
  RunShelf* shelf = nullptr;        // null: that of the process
  std::function<double()> clock_s;  // empty: the steady one
  std::function<void(double share, const std::string& what)> on_progress;  // may be empty
  std::function<bool()> should_stop;                                       // polled as in RunHooks; may be empty
};

/// Amplitude of the noise on every free coordinate of positions at the start of the twin of the reference.
inline constexpr double kTwinNoise_m = 1e-9;
/// No horizon is drawn for errors below this share of the yarn's radius.
inline constexpr double kFinestErrorShare = 1e-3;

/// Runs a checked scene, whose effects are chosen, in all ways of its ladder, and compares them with a reference.
WorkPrecision study_work_precision(const Scene& scene, const WorkPrecisionOptions& options);

}  // namespace slipstitch
