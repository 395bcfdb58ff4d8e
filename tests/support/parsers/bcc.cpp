// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstring>

#include "support/parsers/curves.h"

namespace slipstitch::test {
namespace {

template <class T>
bool take(std::string_view& bytes, T& value) {
  if (bytes.size() < sizeof value) return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return true;
}

struct __attribute__((packed)) Head {
  char sign[3];
  std::uint8_t byte_count;
  char type[2];
  std::uint8_t dimensions, up;
  std::uint64_t curves, points;
  char info[40];
};
static_assert(sizeof(Head) == 64);

bool take_curve(std::string_view& bytes, std::vector<std::array<float, 3>>& curve) {
  std::int32_t count = 0;
  if (!take(bytes, count) || count <= 0 || bytes.size() / 12 < static_cast<std::uint32_t>(count)) return false;
  curve.resize(static_cast<std::size_t>(count));
  for (auto& point : curve) take(bytes, point);
  return true;
}

}  // namespace

std::optional<Bcc> parse_bcc(std::string_view bytes) {
  Head head;
  if (!take(bytes, head) || std::string_view(head.sign, 3) != "BCC" || head.byte_count != 0x44 ||
      head.dimensions != 3 || head.curves > bytes.size() / 4) {
    return std::nullopt;
  }
  Bcc result;
  result.type.assign(head.type, 2);
  result.up = head.up;
  result.info.assign(head.info, ::strnlen(head.info, sizeof head.info));
  std::uint64_t points = 0;
  for (std::uint64_t i = 0; i < head.curves; ++i) {
    if (!take_curve(bytes, result.curves.emplace_back())) return std::nullopt;
    points += result.curves.back().size();
  }
  if (points != head.points || !bytes.empty()) return std::nullopt;
  return result;
}

}  // namespace slipstitch::test
