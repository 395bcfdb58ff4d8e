// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace slipstitch::gauntlet {

/// work(0) .. work(count - 1), on `jobs` threads; returns when all are done. work must not throw.
inline void in_parallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto go = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> threads;
  for (int k = 1; k < jobs; ++k) threads.emplace_back(go);
  go();
}

}  // namespace slipstitch::gauntlet
