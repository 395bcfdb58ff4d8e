// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace slipstitch::test {

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Quotes stay.
inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

/// Row 0 is the head.
inline std::string cell(const std::string& csv, std::size_t row, const std::string& column) {
  const auto lines = lines_of(csv);
  const auto head = cells_of(lines[0]);
  const auto found = std::find(head.begin(), head.end(), column);
  EXPECT_NE(found, head.end()) << column;
  return cells_of(lines[row])[static_cast<std::size_t>(found - head.begin())];
}

}  // namespace slipstitch::test
