// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "math/types.h"
#include "run_dir/result.h"
#include "run_dir/unique_fd.h"

namespace slipstitch {

inline constexpr char kReactionsFile[] = "reactions.csv";  // in report/

/// The forces of the handles on the fabric as they come: "t_s,handle,fx_n,fy_n,fz_n", then a line for every handle of
/// every step, numbers to nine digits. Replaces what was there.
class ReactionsCsv {
 public:
  static Result<ReactionsCsv> create(const std::filesystem::path& file);
  IoError append(double t, const std::vector<Vec3>& forces);

 private:
  IoError append(const std::string& text);

  std::filesystem::path file_;
  UniqueFd fd_;
};

}  // namespace slipstitch
