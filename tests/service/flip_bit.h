// SPDX-License-Identifier: MIT
#pragma once

#include "run_dir/log_bytes.h"

namespace slipstitch::test {

/// One bit of one coordinate of one frame.
struct Flip {
  std::size_t frame = 0, coord = 0;
  int bit = 0;  // 0: the lowest of a double, kFloatBit: the lowest that float32 keeps
};
inline constexpr int kFloatBit = 29;

enum class Checksum { stale, renewed };

/// The bytes of frames.log with that bit changed.
inline std::string flip_bit(std::string log, const Flip& flip, Checksum checksum) {
  std::size_t record = 0;  // the header's, then those of the frames
  const auto length = [&] { return peek<std::uint64_t>(log, record + 24); };
  for (std::size_t before = 0; before <= flip.frame; ++before) record += kRecordHeadBytes + length();
  const std::size_t payload = record + kRecordHeadBytes, at = payload + sizeof(double) * flip.coord;
  poke(log, at, peek<std::uint64_t>(log, at) ^ (std::uint64_t{1} << flip.bit));
  if (checksum == Checksum::renewed) {
    poke(log, record + 36, crc32c(log.substr(record, 32) + log.substr(payload, length())));
  }
  return log;
}

}  // namespace slipstitch::test
