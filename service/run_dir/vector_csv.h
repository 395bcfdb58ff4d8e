// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "math/types.h"
#include "run_dir/result.h"
#include "run_dir/unique_fd.h"

namespace slipstitch {

/// A file of vectors in report/.
struct VectorTable {
  const char* file;
  const char* columns;  // time, index, three components
};
inline constexpr VectorTable kReactionsTable{"reactions.csv", "t_s,handle,fx_n,fy_n,fz_n"};  // of handles on the fabric
inline constexpr VectorTable kBodiesTable{"bodies.csv", "t_s,body,x_m,y_m,z_m"};             // centres

/// Writes a table as it comes: the columns, then a line for every vector of every time, numbers to nine digits.
/// Replaces what was there.
class VectorCsv {
 public:
  static Result<VectorCsv> create(const std::filesystem::path& folder, const VectorTable& table);
  IoError append(double t, const std::vector<Vec3>& vectors);

 private:
  IoError append(const std::string& text);

  std::filesystem::path file_;
  UniqueFd fd_;
};

}  // namespace slipstitch
