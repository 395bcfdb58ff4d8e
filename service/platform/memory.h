// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace slipstitch {

/// Largest resident memory of this process since its program started [bytes]; nothing where /proc does not tell.
std::optional<long> peak_memory_bytes();

}  // namespace slipstitch
