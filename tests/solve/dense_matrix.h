// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <vector>

#include "solve/sparse_pattern.h"

namespace slipstitch::testing {

inline std::shared_ptr<const SparsePattern> full_pattern(int n) {
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  return make_pattern(n, std::vector<std::vector<int>>{all});
}

/// Writes the lower triangle of `dense` into the pattern of `a`; entries outside the pattern must be zero.
inline void set_values(const Eigen::MatrixXd& dense, SparseMatrix& a) {
  a.values.clear();
  for (int c = 0; c < a.pattern->n; ++c)
    for (int k = a.pattern->column_first[static_cast<std::size_t>(c)];
         k < a.pattern->column_first[static_cast<std::size_t>(c) + 1]; ++k)
      a.values.push_back(dense(a.pattern->row[static_cast<std::size_t>(k)], c));
}

inline SparseMatrix sparse(const Eigen::MatrixXd& dense, std::shared_ptr<const SparsePattern> pattern) {
  SparseMatrix a{std::move(pattern), {}};
  set_values(dense, a);
  return a;
}

}  // namespace slipstitch::testing
