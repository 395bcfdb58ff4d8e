// SPDX-License-Identifier: MIT
#include "cli/screen/text.h"

#include <algorithm>

namespace slipstitch {

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

std::string wrapped(const std::string& head, const std::string& text) {
  constexpr std::size_t kWidth = 78;
  std::string all = head;
  std::size_t used = head.size();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (used + 1 + end - at > kWidth) {
      all += "\n   ";
      used = 3;
    }
    all += " " + text.substr(at, end - at);
    used += 1 + end - at;
    at = end + 1;
  }
  return all + "\n";
}

}  // namespace slipstitch
