// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "dense_matrix.h"

namespace slipstitch::testing {
namespace {

TEST(SparsePattern, IsTheUnionOfCliquesWithTheDiagonal) {
  const std::vector<std::vector<int>> cliques = {{0, 3}, {3, 0, -1}, {2, 4, 3}, {-1, -1}};
  const auto pattern = make_pattern(6, cliques);
  EXPECT_EQ(pattern->n, 6);
  EXPECT_EQ(pattern->column_first, (std::vector<int>{0, 2, 3, 6, 8, 9, 10}));
  EXPECT_EQ(pattern->row, (std::vector<int>{0, 3, 1, 2, 3, 4, 3, 4, 4, 5}));
  EXPECT_EQ(pattern->nonzeros(), 10);
}

TEST(SparsePattern, FindsTheSlotOfEveryEntry) {
  const auto pattern = make_pattern(5, std::vector<std::vector<int>>{{0, 2, 4}, {1, 2}, {3, 4}});
  for (int c = 0; c < pattern->n; ++c) {
    for (int k = pattern->column_first[static_cast<std::size_t>(c)];
         k < pattern->column_first[static_cast<std::size_t>(c) + 1]; ++k) {
      EXPECT_EQ(pattern->slot(pattern->row[static_cast<std::size_t>(k)], c), k);
    }
  }
}

TEST(SparsePattern, WithoutCliquesIsTheDiagonal) {
  const auto pattern = make_pattern(3, {});
  EXPECT_EQ(pattern->row, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(make_pattern(0, {})->nonzeros(), 0);
}

TEST(SparsePattern, TakesInFurtherCliquesAndKnowsWhereItsEntriesWent) {
  const std::vector<std::vector<int>> lasting = {{0, 3}, {2, 4}}, first = {{1, 4}}, second = {{3, 0, -1}, {3, 4, 2}};
  const auto base = make_pattern(5, lasting);
  const auto before = with_cliques(*base, first), after = with_cliques(*base, second);
  EXPECT_EQ(before->row, (std::vector<int>{0, 3, 1, 4, 2, 4, 3, 4}));
  EXPECT_EQ(after->column_first, (std::vector<int>{0, 2, 3, 6, 8, 9}));
  EXPECT_EQ(after->row, (std::vector<int>{0, 3, 1, 2, 3, 4, 3, 4, 4}));
  EXPECT_EQ(slots_in(*before, *after), (std::vector<int>{0, 1, 2, -1, 3, 5, 6, 8}));
}

TEST(SparseMatrix, MultipliesAsTheFullSymmetricMatrix) {
  Eigen::MatrixXd dense(4, 4);
  dense << 4, -1, 0, 2,  //
      -1, 3, 0, 0,       //
      0, 0, 5, 1,        //
      2, 0, 1, 6;
  const auto a = sparse(dense, make_pattern(4, std::vector<std::vector<int>>{{0, 1}, {0, 3}, {2, 3}}));
  VecX x(4), y;
  x << 1.0, -2.0, 0.5, 3.0;
  multiply(a, x, y);
  EXPECT_LT((y - dense * x).norm(), 1e-15);
}

}  // namespace
}  // namespace slipstitch::testing
