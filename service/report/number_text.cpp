// SPDX-License-Identifier: MIT
#include "report/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace slipstitch {
namespace {

std::string printed(const char* format, auto... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace

std::string thousands(long count) {
  const std::string digits = std::to_string(count);
  const std::size_t sign = count < 0 ? 1 : 0;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > sign && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string short_number(double value, int digits) { return printed("%.*g", digits, value); }

std::string plain_number(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return short_number(value, digits);
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return printed("%.*f", std::max(0, digits - 1 - exponent), value);
}

std::string metres_text(double metres) {
  const double size = std::abs(metres);
  if (size == 0.0) return "0 mm";
  if (size < 1e-9) return short_number(metres) + " m";
  if (size < 1e-6) return short_number(metres * 1e9) + " nm";
  if (size < 1e-4) return short_number(metres * 1e6) + " um";
  if (size < 1.0) return short_number(metres * 1e3) + " mm";
  return short_number(metres) + " m";
}

std::string bytes_text(double bytes) {
  constexpr std::array kUnits{"B", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 999.5 && unit + 1 < kUnits.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return printed(bytes < 9.95 && unit > 0 ? "%.1f %s" : "%.0f %s", bytes, kUnits[unit]);
}

std::string duration_text(double seconds) {
  if (seconds < 0.0995) return printed("%.0f ms", seconds * 1e3);
  if (seconds < 59.95) return printed("%.1f s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 3600) return printed("%ld min %02ld s", whole / 60, whole % 60);
  return printed("%ld h %02ld min", whole / 3600, whole % 3600 / 60);
}

std::string clock_text(double seconds) {
  const long whole = std::lround(std::clamp(seconds, 0.0, 3.6e7));
  if (whole < 3600) return printed("%ld:%02ld", whole / 60, whole % 60);
  return printed("%ld:%02ld:%02ld", whole / 3600, whole % 3600 / 60, whole % 60);
}

std::string percent_text(double share) {
  const double percent = 100.0 * share;
  if (percent == 0.0 || percent >= 9.95) return printed("%.0f %%", percent);
  return percent < 0.1 ? "< 0.1 %" : printed("%.1f %%", percent);
}

std::string count_of(long count, const std::string& one, const std::string& many) {
  return thousands(count) + " " + (count == 1 ? one : many);
}

}  // namespace slipstitch
