// SPDX-License-Identifier: MIT
#include "cli/screen/text.h"

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
  std::string text = std::to_string(count);
  const std::size_t sign = count < 0 ? 1 : 0;
  for (std::size_t place = text.size(); place > 3 + sign;) text.insert(place -= 3, ",");
  return text;
}

std::string short_number(double value, int digits) { return printed("%.*g", digits, value); }

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

std::vector<std::string> wrap_list(const std::vector<std::string>& words, std::size_t width) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i] + (i + 1 < words.size() ? "," : "");
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

std::string two_columns(const Rows& rows) {
  std::size_t width = 0;
  for (const auto& [name, value] : rows) width = std::max(width, name.size());
  std::string text;
  for (const auto& [name, value] : rows) {
    std::string line = "  " + name + std::string(width - name.size() + 2, ' ');
    for (const char c : value) {
      line += c;
      if (c == '\n') line += std::string(width + 4, ' ');
    }
    text += line + "\n";
  }
  return text;
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace slipstitch
