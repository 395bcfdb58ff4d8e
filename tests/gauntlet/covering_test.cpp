// SPDX-License-Identifier: MIT
#include "gauntlet/covering.h"

#include <gtest/gtest.h>

namespace slipstitch::gauntlet {
namespace {

bool stand_together(const std::vector<std::vector<int>>& rows, std::size_t a, int x, std::size_t b, int y) {
  for (const auto& row : rows)
    if (row[a] == x && row[b] == y) return true;
  return false;
}

TEST(Covering, HasEveryTwoValuesTogether) {
  const std::vector<int> levels{7, 5, 3, 2, 2};
  const auto rows = pairwise_covering(levels);
  for (std::size_t a = 0; a < levels.size(); ++a)
    for (std::size_t b = a + 1; b < levels.size(); ++b)
      for (int x = 0; x < levels[a]; ++x)
        for (int y = 0; y < levels[b]; ++y) EXPECT_TRUE(stand_together(rows, a, x, b, y)) << a << b << x << y;
  EXPECT_LE(rows.size(), 7U * 5U + 3U);  // 7 * 5 are needed
}

}  // namespace
}  // namespace slipstitch::gauntlet
