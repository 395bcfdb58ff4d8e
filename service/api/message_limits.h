// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace slipstitch {

/// No message the server sends is above this, so that no client has to raise its limits.
inline constexpr std::size_t kMaxMessageBytes = 1 << 20;

/// Payload of one chunk of a frame, header or artefact; well below the limit with the fields around it.
inline constexpr std::uint64_t kChunkBytes = 512 * 1024;

/// Jobs of one page together.
inline constexpr std::size_t kMaxListBytes = 768 * 1024;

}  // namespace slipstitch
