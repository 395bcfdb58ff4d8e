// SPDX-License-Identifier: MIT
#include "model/check_values.h"

#include <charconv>

namespace slipstitch {

std::string number_text(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

std::string element(const std::string& path, std::size_t index) { return path + "[" + std::to_string(index) + "]"; }

Issue too_many(const std::string& path, const std::string& count, int limit, const std::string& things) {
  const std::string expected = "at most " + std::to_string(limit) + " " + things;
  return {path, count + " " + things, expected, true, 0, 0, limit};
}

void Checker::finite(const std::string& path, const Vec3& value) {
  for (int c = 0; c < 3; ++c) finite(element(path, static_cast<std::size_t>(c)), value[c]);
}

void Checker::require(bool holds, const std::string& path, double value, const std::string& expected) {
  if (!holds || !std::isfinite(value)) fail(path, number_text(value), expected);
}

void Checker::require_index(const std::string& path, int value, int smallest, int largest) {
  if (value >= smallest && value <= largest) return;
  fail(path, std::to_string(value), std::to_string(smallest) + " to " + std::to_string(largest));
}

}  // namespace slipstitch
