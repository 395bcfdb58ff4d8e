// SPDX-License-Identifier: MIT
#include "prediction/cpu_name.h"

#include <cpuid.h>

#include <array>
#include <cstring>

namespace slipstitch {

std::string cpu_name() {
  constexpr unsigned kFirst = 0x80000002, kParts = 3;  // of the brand string, 16 bytes each
  std::array<unsigned, 4 * kParts> words{};
  for (unsigned i = 0; i < kParts; ++i) {
    unsigned* part = &words[4 * i];
    if (__get_cpuid(kFirst + i, &part[0], &part[1], &part[2], &part[3]) == 0) return {};
  }
  std::array<char, sizeof(words) + 1> text{};
  std::memcpy(text.data(), words.data(), sizeof(words));
  return text.data();
}

}  // namespace slipstitch
