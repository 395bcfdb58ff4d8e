// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

/// A text as a cell of a CSV file.
inline std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

}  // namespace slipstitch
