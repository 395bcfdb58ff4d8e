// SPDX-License-Identifier: MIT
#include <bit>
#include <cstdint>

#include "formats/formats.h"

// Binary curve collection, Cem Yuksel, http://www.cemyuksel.com/cyCodeBase/soln/using_bcc_files.html. Little endian, a
// head of 64 bytes, then per curve an int32 count (negative: closed) and float32 coordinates.

namespace slipstitch {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string write_bcc(const CurveFrame& frame) {
  std::uint64_t curves = 0;
  for (int yarn = 0; yarn < frame.num_yarns(); ++yarn) {
    const auto y = static_cast<std::size_t>(yarn);
    curves += frame.first[y + 1] > frame.first[y];  // a curve of no points is not allowed
  }
  std::string bytes = "BCC";
  bytes += '\x44';  // 4-byte integers and floats
  bytes += "C0";    // Catmull-Rom through the points: the type of Yuksel's own files, which every reader knows
  bytes += '\x03';  // dimensions
  bytes += '\x01';  // y is up
  append(bytes, curves);
  append(bytes, static_cast<std::uint64_t>(frame.points.size()));
  bytes += "slipstitch, unit: metre";
  bytes.resize(64, '\0');
  for (std::size_t yarn = 0; yarn + 1 < frame.first.size(); ++yarn) {
    const int count = frame.first[yarn + 1] - frame.first[yarn];
    if (count == 0) continue;
    append(bytes, static_cast<std::int32_t>(count));
    for (int point = frame.first[yarn]; point < frame.first[yarn + 1]; ++point) {
      for (const double x : frame.points[static_cast<std::size_t>(point)]) append(bytes, static_cast<float>(x));
    }
  }
  return bytes;
}

}  // namespace slipstitch
