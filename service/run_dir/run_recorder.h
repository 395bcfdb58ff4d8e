// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "run_dir/run_dir.h"
#include "sim/run.h"

namespace slipstitch {

struct RecorderOptions {
  double progress_interval_s = 0.1;   // at most one progress.json per interval; the last is always written
  double control_interval_s = 0.005;  // at most one look at control.log per interval
  std::function<void(const Progress&)> on_progress;  // called for every step; may be empty
  std::function<bool()> should_stop;                 // asked besides control.log; may be empty
};

/// Writes a run into its directory: frames.log, progress.json, report/history.csv, report/reactions.csv where there are
/// handles, report/bodies.csv where there are dynamic colliders, and with finish() the end, the last progress and summary.json. When the disk refuses, the run is stopped and its summary says
/// failed with the reason.
class RunRecorder {
 public:
  RunRecorder(RunDir dir, RecorderOptions options = {});
  ~RunRecorder();
  RunRecorder(RunRecorder&&) noexcept;
  RunRecorder& operator=(RunRecorder&&) noexcept;

  /// For run(); valid while the recorder lives.
  RunHooks hooks();

  /// Returns the summary as written: of `summary`, but failed if frames could not be recorded.
  Result<RunSummary> finish(RunSummary summary);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slipstitch
