// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "run_dir/result.h"

namespace slipstitch {

/// control.log: commands to the process that runs the job, one a line, append-only.
inline constexpr std::string_view kCancelCommand = "cancel";

IoError append_command(const std::filesystem::path& file, std::string_view command);

/// Hands out each complete line once. A missing file has none yet.
class ControlLogReader {
 public:
  explicit ControlLogReader(std::filesystem::path file) : file_(std::move(file)) {}
  std::vector<std::string> poll();

 private:
  std::filesystem::path file_;
  std::uint64_t offset_ = 0;
};

}  // namespace slipstitch
