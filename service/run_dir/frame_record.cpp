// SPDX-License-Identifier: MIT
#include "run_dir/frame_record.h"

#include <bit>
#include <boost/crc.hpp>
#include <cmath>
#include <cstring>

namespace slipstitch {
namespace {

static_assert(std::endian::native == std::endian::little, "frames.log is little endian");

using Crc32c = boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true>;  // RFC 3720

constexpr std::array<unsigned char, 4> kMagic{'S', 'L', 'P', 'R'};
constexpr std::size_t kCheckedHeadBytes = 32;

template <class T>
void put(RecordHeadBytes& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <class T>
T get(const RecordHeadBytes& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::uint32_t head_crc(const RecordHeadBytes& bytes) {
  Crc32c crc;
  crc.process_bytes(bytes.data(), kCheckedHeadBytes);
  return crc.checksum();
}

std::uint32_t record_crc(const RecordHeadBytes& bytes, const void* payload, std::size_t length) {
  Crc32c crc;
  crc.process_bytes(bytes.data(), kCheckedHeadBytes);
  crc.process_bytes(payload, length);
  return crc.checksum();
}

}  // namespace

RecordHeadBytes encode_head(const RecordHead& head, const void* payload) {
  RecordHeadBytes bytes{};
  std::memcpy(bytes.data(), kMagic.data(), kMagic.size());
  put(bytes, 4, kRecordVersion);
  put(bytes, 6, head.kind);
  put(bytes, 7, head.encoding);
  put(bytes, 8, head.index);
  put(bytes, 16, head.t);
  put(bytes, 24, head.length);
  put(bytes, 32, head_crc(bytes));
  put(bytes, 36, record_crc(bytes, payload, head.length));
  return bytes;
}

std::string decode_head(const RecordHeadBytes& bytes, RecordHead& head) {
  if (std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) != 0) return "no record starts here";
  if (get<std::uint32_t>(bytes, 32) != head_crc(bytes)) return "checksum of the record's head does not match";
  if (const auto version = get<std::uint16_t>(bytes, 4); version != kRecordVersion) {
    return "record version " + std::to_string(version) + " is not supported, only " + std::to_string(kRecordVersion);
  }
  head.kind = static_cast<RecordKind>(bytes[6]);
  head.encoding = static_cast<RecordEncoding>(bytes[7]);
  head.index = get<std::int64_t>(bytes, 8);
  head.t = get<double>(bytes, 16);
  head.length = get<std::uint64_t>(bytes, 24);
  return std::isfinite(head.t) ? "" : "simulated time is not finite";
}

bool payload_matches(const RecordHeadBytes& bytes, const void* payload, std::size_t length) {
  return get<std::uint32_t>(bytes, 36) == record_crc(bytes, payload, length);
}

}  // namespace slipstitch
