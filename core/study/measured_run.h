// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/run.h"
#include "study/frame_trace.h"

namespace slipstitch {

/// Positions of a run's frames.
struct RecordedFrames {
  std::vector<VecX> x;  // of every node, in the order of the nodes [m]
};

/// Differences between the frames of two runs, as far as both have come, over the nodes that both have.
struct FrameDifference {
  double max_m = 0.0, rms_m = 0.0;  // of any node at any frame; root mean square over nodes and frames
};

/// What one run took and gave.
struct MeasuredRun {
  RunSummary summary;
  double memory_bytes = 0.0;  // heap in use at the last step, less what was in use before and what is recorded
  long effort = 0;            // times the run asked whether to stop, about once a Newton iteration
  double stored_j = 0.0;      // energy in yarn and contacts at the end, without weight and loads
  double tension_n = 0.0;     // largest in any segment at any step, EA (stretch - 1)
  double reaction_n = 0.0;    // largest of any handle at any step; 0 without handles
  FrameDifference difference;
};

struct MeasureOptions {
  int threads = 1;
  RecordedFrames* record = nullptr;               // filled
  const RecordedFrames* reference = nullptr;      // what `difference` is taken to
  FrameTrace* trace = nullptr;                    // filled; costs an evaluation of the energies a frame
  std::function<void(Model&)> on_model;           // as in RunHooks; may be empty
  long max_effort = 0;                            // cancels the run beyond; 0: never
  double max_cost = 0.0;                          // cancels it beyond this effort times nonzeros; 0: never
  double max_difference_m = 0.0;                  // cancels it once it differs by more; 0: never
  std::function<void(double share)> on_progress;  // of the run done, 0 to 1; may be empty
  std::function<bool()> should_stop;              // may be empty
};

/// Runs a checked scene whose effects are chosen; one with a budget to a tenth of its yarn's radius instead, as runs
/// that take the time they are given have no cost to compare.
MeasuredRun measure_run(const Scene& scene, const MeasureOptions& options);

}  // namespace slipstitch
