// SPDX-License-Identifier: MIT
#pragma once

#include <malloc.h>

namespace slipstitch {

/// Of this process [bytes].
inline double heap_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

}  // namespace slipstitch
