// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <random>

#include "math/types.h"

namespace slipstitch::gauntlet {

/// Random numbers that a seed fixes on every platform: the distributions of <random> differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  double unit();                                // in [0, 1)
  double uniform(double low, double high);      // in [low, high)
  double log_uniform(double low, double high);  // in [low, high], 0 < low; every octave as likely as every other
  int between(int low, int high);               // both included
  bool chance(double share);
  Vec3 direction();  // unit, all alike

  template <class T, std::size_t N>
  const T& pick(const std::array<T, N>& from) {
    return from[static_cast<std::size_t>(between(0, static_cast<int>(N) - 1))];
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace slipstitch::gauntlet
