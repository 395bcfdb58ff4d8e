// SPDX-License-Identifier: MIT
#include "gauntlet/covering.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace slipstitch::gauntlet {
namespace {

using Row = std::vector<int>;
using Pair = std::tuple<int, int, int, int>;  // column, value, column, value

void for_each_pair(const Row& row, auto&& f) {
  for (int a = 0; a < static_cast<int>(row.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(row.size()); ++b)
      f(Pair{a, row[static_cast<std::size_t>(a)], b, row[static_cast<std::size_t>(b)]});
}

/// Next row in counting order with the first column as it is; false: there is none.
bool next(Row& row, const std::vector<int>& levels) {
  for (std::size_t c = row.size(); c-- > 1;) {
    if (++row[c] < levels[c]) return true;
    row[c] = 0;
  }
  return false;
}

std::set<Pair> all_pairs(const std::vector<int>& levels) {
  std::set<Pair> pairs;
  for (int first = 0; first < levels[0]; ++first) {
    Row row(levels.size(), 0);
    row[0] = first;
    do for_each_pair(row, [&](const Pair& pair) { pairs.insert(pair); });
    while (next(row, levels));
  }
  return pairs;
}

Row best_row(int first, const std::vector<int>& levels, const std::set<Pair>& open) {
  Row row(levels.size(), 0), best;
  row[0] = first;
  long most = -1;
  do {
    long found = 0;
    for_each_pair(row, [&](const Pair& pair) { found += static_cast<long>(open.count(pair)); });
    if (found <= most) continue;
    most = found;
    best = row;
  } while (next(row, levels));
  return best;
}

}  // namespace

std::vector<Row> pairwise_covering(const std::vector<int>& levels) {
  std::set<Pair> open = all_pairs(levels);
  std::vector<Row> rows;
  for (int first = 0; first < levels[0]; ++first) {
    const auto mine = [&] {
      return std::any_of(open.begin(), open.end(),
                         [&](const Pair& pair) { return std::get<0>(pair) == 0 && std::get<1>(pair) == first; });
    };
    const bool last = first + 1 == levels[0];
    while (mine() || (last && !open.empty())) {
      rows.push_back(best_row(first, levels, open));
      for_each_pair(rows.back(), [&](const Pair& pair) { open.erase(pair); });
    }
  }
  return rows;
}

}  // namespace slipstitch::gauntlet
