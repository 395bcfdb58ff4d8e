// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace slipstitch {

/// frames.log is a sequence of records: 40 bytes of head, then `length` bytes of payload. Little endian.
///
///   offset type  field
///    0     u32   magic "SLPR"
///    4     u16   version 1
///    6     u8    kind
///    7     u8    encoding of the payload
///    8     i64   index: of the frame; 0 for the header; number of frames for the end
///   16     f64   simulated time [s]
///   24     u64   length of the payload [byte]
///   32     u32   CRC32C of bytes 0..31: a broken length is told from a torn tail
///   36     u32   CRC32C of bytes 0..31 followed by the payload
///
/// First the header (FrameHeader, header_codec.h), then frames 0, 1, 2, ..., then, if the run ended in an orderly way,
/// the end (no payload). Nothing follows the end.
enum class RecordKind : std::uint8_t { header = 1, frame = 2, end = 3 };

enum class RecordEncoding : std::uint8_t {
  none = 0,      // no payload
  topology = 1,  // header_codec.h
  raw_f64 = 2,   // q as doubles
};

struct RecordHead {
  RecordKind kind = RecordKind::frame;
  RecordEncoding encoding = RecordEncoding::none;
  std::int64_t index = 0;
  double t = 0.0;
  std::uint64_t length = 0;
};

inline constexpr std::size_t kRecordHeadBytes = 40;
inline constexpr std::uint16_t kRecordVersion = 1;
using RecordHeadBytes = std::array<unsigned char, kRecordHeadBytes>;

/// Head bytes with both checksums, ready to be written in front of `payload`.
RecordHeadBytes encode_head(const RecordHead& head, const void* payload);

/// Empty: `head` is set. Otherwise why these bytes are no head.
std::string decode_head(const RecordHeadBytes& bytes, RecordHead& head);

bool payload_matches(const RecordHeadBytes& bytes, const void* payload, std::size_t length);

}  // namespace slipstitch
