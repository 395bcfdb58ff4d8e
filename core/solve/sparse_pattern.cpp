// SPDX-License-Identifier: MIT
#include "solve/sparse_pattern.h"

#include <algorithm>
#include <cassert>

namespace slipstitch {

int SparsePattern::slot(int r, int c) const {
  const auto first = row.begin() + column_first[static_cast<std::size_t>(c)];
  const auto last = row.begin() + column_first[static_cast<std::size_t>(c) + 1];
  const auto it = std::lower_bound(first, last, r);
  assert(it != last && *it == r);
  return static_cast<int>(it - row.begin());
}

bool SparsePattern::contains(std::span<const int> clique) const {
  for (std::size_t i = 0; i < clique.size(); ++i) {
    const auto c = static_cast<std::size_t>(clique[i]);
    auto first = row.begin() + column_first[c];
    const auto last = row.begin() + column_first[c + 1];
    for (std::size_t j = i; j < clique.size(); ++j) {
      first = std::lower_bound(first, last, clique[j]);
      if (first == last || *first != clique[j]) return false;
    }
  }
  return true;
}

std::shared_ptr<const SparsePattern> make_pattern(int n, std::span<const std::vector<int>> cliques) {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(n));
  for (int c = 0; c < n; ++c) columns[static_cast<std::size_t>(c)].push_back(c);
  for (const auto& clique : cliques) {
    for (int c : clique) {
      if (c < 0) continue;
      auto& column = columns[static_cast<std::size_t>(c)];
      for (int r : clique)
        if (r > c) column.push_back(r);
    }
  }
  auto pattern = std::make_shared<SparsePattern>();
  pattern->n = n;
  pattern->column_first.assign(1, 0);
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    pattern->row.insert(pattern->row.end(), column.begin(), column.end());
    pattern->column_first.push_back(pattern->nonzeros());
  }
  return pattern;
}

void multiply(const SparseMatrix& a, const VecX& x, VecX& y) {
  const auto& p = *a.pattern;
  y.setZero(p.n);
  for (int c = 0; c < p.n; ++c) {
    double sum = 0.0;
    for (int k = p.column_first[static_cast<std::size_t>(c)]; k < p.column_first[static_cast<std::size_t>(c) + 1]; ++k) {
      const int r = p.row[static_cast<std::size_t>(k)];
      const double value = a.values[static_cast<std::size_t>(k)];
      sum += value * x[r];
      if (r != c) y[r] += value * x[c];
    }
    y[c] += sum;
  }
}

}  // namespace slipstitch
