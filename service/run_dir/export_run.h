// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "formats/formats.h"
#include "run_dir/result.h"
#include "run_dir/run_dir.h"

namespace slipstitch {

struct ExportOptions {
  int first = 0;   // index of the first frame, >= 0
  int stride = 1;  // every stride-th from there, >= 1
  bool force = false;
  std::function<bool()> should_stop;  // asked between frames; may be empty
};

struct ExportReport {
  int frames = 0;          // files written
  bool run_ended = false;  // false: the run goes on, or died; what there was is exported
};

/// Frames of a run directory as files. Fails, with the good frames before it written, at a broken frame.
Result<ExportReport> export_run(const RunDir& run, const std::filesystem::path& folder, const Format& format,
                                const ExportOptions& options);

}  // namespace slipstitch
