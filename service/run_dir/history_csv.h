// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "run_dir/result.h"
#include "run_dir/unique_fd.h"
#include "sim/frame_report.h"

namespace slipstitch {

inline constexpr char kHistoryFile[] = "history.csv";

/// A row for every frame of a run, in report/: counters since the start, the last step, energies by term [J]; an empty
/// cell was not measured. Every row goes to the kernel before its call returns; who reads meanwhile may find the last
/// line incomplete.
class HistoryCsv {
 public:
  /// Replaces what was there. The columns of energies are those of `first`, which is not written.
  static Result<HistoryCsv> create(const std::filesystem::path& folder, const FrameReport& first);
  IoError append(const FrameReport& report);

 private:
  IoError write(const std::string& line);

  std::filesystem::path file_;
  UniqueFd fd_;
  std::vector<std::string> terms_;
};

}  // namespace slipstitch
