// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "run_dir/frame_log.h"
#include "support/sample_run.h"

namespace slipstitch::test {

/// CRC-32C bit by bit (RFC 3720, appendix B.4), independent of the library used.
inline std::uint32_t crc32c(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0x82F63B78u : 0u);
  }
  return ~crc;
}

template <class T>
void poke(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <class T>
T peek(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A record with valid checksums around any content.
inline std::string forge_record(std::uint8_t kind, std::uint8_t encoding, std::int64_t index, std::uint64_t length,
                                std::string_view payload) {
  std::string bytes("SLPR\1\0\0\0", 8);
  bytes.resize(40, '\0');
  poke(bytes, 6, kind);
  poke(bytes, 7, encoding);
  poke(bytes, 8, index);
  poke(bytes, 24, length);
  poke(bytes, 32, crc32c(std::string_view(bytes).substr(0, 32)));
  poke(bytes, 36, crc32c(bytes.substr(0, 32) + std::string(payload)));
  return bytes + std::string(payload);
}

inline void write_log(const std::filesystem::path& file, int num_frames, bool end) {
  Result<FrameLogWriter> writer = FrameLogWriter::create(file);
  ASSERT_TRUE(writer) << writer.error;
  const FrameHeader header = sample_header();
  ASSERT_EQ(writer->append_header(header), "");
  for (int index = 0; index < num_frames; ++index) ASSERT_EQ(writer->append_frame(sample_frame(header, index)), "");
  if (end) {
    ASSERT_EQ(writer->append_end(2.0), "");
  }
}

/// Frames that can be read, up to the first that cannot; every one must be the one that was written.
inline int good_prefix(FrameLogReader& reader) {
  reader.poll();
  int good = 0;
  for (; good < reader.num_frames(); ++good) {
    const Result<Frame> frame = reader.read_frame(good);
    if (!frame) break;
    const Frame expected = sample_frame(sample_header(), good);
    EXPECT_EQ(frame->index, good);
    EXPECT_EQ(frame->t, expected.t);
    EXPECT_EQ(frame->q, expected.q);
  }
  return good;
}

inline constexpr std::size_t kSampleFrameBytes = 40 + 8 * (3 * 6 + 7);

}  // namespace slipstitch::test
