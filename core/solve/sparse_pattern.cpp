// SPDX-License-Identifier: MIT
#include "solve/sparse_pattern.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

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
  SparsePattern diagonal;
  diagonal.n = n;
  diagonal.row.resize(static_cast<std::size_t>(n));
  std::iota(diagonal.row.begin(), diagonal.row.end(), 0);
  diagonal.column_first.resize(static_cast<std::size_t>(n) + 1);
  std::iota(diagonal.column_first.begin(), diagonal.column_first.end(), 0);
  return with_cliques(diagonal, cliques);
}

std::shared_ptr<const SparsePattern> with_cliques(const SparsePattern& base,
                                                  std::span<const std::vector<int>> cliques) {
  std::vector<std::vector<const std::vector<int>*>> cliques_of(static_cast<std::size_t>(base.n));
  for (const auto& clique : cliques)
    for (int c : clique)
      if (c >= 0) cliques_of[static_cast<std::size_t>(c)].push_back(&clique);
  auto pattern = std::make_shared<SparsePattern>();
  pattern->n = base.n;
  pattern->column_first.assign(1, 0);
  std::vector<int> last_column(static_cast<std::size_t>(base.n), -1);  // that an entry in the row was put into
  for (int c = 0; c < base.n; ++c) {
    const auto put = [&](int r) {
      if (r < c || last_column[static_cast<std::size_t>(r)] == c) return;
      last_column[static_cast<std::size_t>(r)] = c;
      pattern->row.push_back(r);
    };
    const auto column = static_cast<std::size_t>(c);
    const auto first = pattern->row.size();
    for (int k = base.column_first[column]; k < base.column_first[column + 1]; ++k)
      put(base.row[static_cast<std::size_t>(k)]);
    for (const auto* clique : cliques_of[column])
      for (int r : *clique) put(r);
    std::sort(pattern->row.begin() + static_cast<std::ptrdiff_t>(first), pattern->row.end());
    pattern->column_first.push_back(pattern->nonzeros());
  }
  return pattern;
}

std::vector<int> slots_in(const SparsePattern& from, const SparsePattern& to) {
  std::vector<int> slots(from.row.size(), -1);
  for (std::size_t c = 0; c < static_cast<std::size_t>(from.n); ++c) {
    auto k = static_cast<std::size_t>(to.column_first[c]);
    const auto end = static_cast<std::size_t>(to.column_first[c + 1]);
    for (auto i = static_cast<std::size_t>(from.column_first[c]);
         i < static_cast<std::size_t>(from.column_first[c + 1]); ++i) {
      while (k < end && to.row[k] < from.row[i]) ++k;
      if (k < end && to.row[k] == from.row[i]) slots[i] = static_cast<int>(k);
    }
  }
  return slots;
}

namespace {

/// y = f(A) x with the full symmetric A, f of each entry.
template <class F>
void multiply_entries(const SparseMatrix& a, const VecX& x, VecX& y, const F& f) {
  const auto& p = *a.pattern;
  y.setZero(p.n);
  for (int c = 0; c < p.n; ++c) {
    double sum = 0.0;
    for (int k = p.column_first[static_cast<std::size_t>(c)]; k < p.column_first[static_cast<std::size_t>(c) + 1];
         ++k) {
      const int r = p.row[static_cast<std::size_t>(k)];
      const double value = f(a.values[static_cast<std::size_t>(k)]);
      sum += value * x[r];
      if (r != c) y[r] += value * x[c];
    }
    y[c] += sum;
  }
}

}  // namespace

void multiply(const SparseMatrix& a, const VecX& x, VecX& y) {
  multiply_entries(a, x, y, [](double value) { return value; });
}

void multiply_magnitudes(const SparseMatrix& a, const VecX& x, VecX& y) {
  multiply_entries(a, x.cwiseAbs(), y, [](double value) { return std::abs(value); });
}

}  // namespace slipstitch
