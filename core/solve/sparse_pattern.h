// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "math/types.h"

namespace slipstitch {

/// Lower triangle of a symmetric matrix in compressed columns, rows ascending; the diagonal is always present.
struct SparsePattern {
  int n = 0;
  std::vector<int> column_first;  // (n + 1)
  std::vector<int> row;           // (nonzeros)

  int nonzeros() const { return static_cast<int>(row.size()); }
  /// Position of entry (r, c), r >= c. The entry must exist.
  int slot(int r, int c) const;
  /// Whether all pairs of the given indices (ascending, no negatives) have entries.
  bool contains(std::span<const int> clique) const;
};

/// Union of the cliques of the given index lists (each ascending or not, indices in [0, n), negatives skipped).
std::shared_ptr<const SparsePattern> make_pattern(int n, std::span<const std::vector<int>> cliques);

/// Union of a pattern and cliques as above.
std::shared_ptr<const SparsePattern> with_cliques(const SparsePattern& base, std::span<const std::vector<int>> cliques);

/// Position in `to` of every entry of `from`, -1 where it has none. Same n.
std::vector<int> slots_in(const SparsePattern& from, const SparsePattern& to);

struct SparseMatrix {
  std::shared_ptr<const SparsePattern> pattern;
  std::vector<double> values;  // (nonzeros)
};

/// y = A x with the full symmetric A.
void multiply(const SparseMatrix& a, const VecX& x, VecX& y);
/// y = |A| |x|, entry by entry.
void multiply_magnitudes(const SparseMatrix& a, const VecX& x, VecX& y);

}  // namespace slipstitch
