// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/frame_trace.h"

namespace slipstitch {

/// A run that has ended by itself, and all that a study needs of it later.
struct KeptRun {
  RunSummary summary;
  std::vector<double> wall_s;  // of every time it was run [s]
  double memory_bytes = 0.0;   // as in MeasuredRun, the least of all times
  FrameTrace trace;
};

/// Where a study puts what it has run, and finds it again.
class RunShelf {
 public:
  RunShelf() = default;
  RunShelf(const RunShelf&) = delete;
  RunShelf& operator=(const RunShelf&) = delete;
  virtual ~RunShelf() = default;

  /// Nothing: not there, or damaged.
  virtual std::optional<KeptRun> find(const std::string& key) = 0;
  /// In place of one of the same key. Empty: done; otherwise what went wrong.
  virtual std::string keep(const std::string& key, const KeptRun& run) = 0;
};

/// That of a process.
std::unique_ptr<RunShelf> make_memory_shelf();

}  // namespace slipstitch
