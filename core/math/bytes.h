// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace slipstitch {

/// Of the elements of vectors.
template <class... T>
long bytes_of(const std::vector<T>&... tables) {
  return static_cast<long>(((tables.size() * sizeof(T)) + ... + 0));
}

}  // namespace slipstitch
