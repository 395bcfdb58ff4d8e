// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace slipstitch::gauntlet {

/// Rows of a table whose column c takes the values 0 .. levels[c] - 1, such that every two values of every two columns
/// stand together in some row. Rows come in the order of the first column, as few as a greedy choice finds; the same on
/// every call.
std::vector<std::vector<int>> pairwise_covering(const std::vector<int>& levels);

}  // namespace slipstitch::gauntlet
