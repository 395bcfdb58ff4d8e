// SPDX-License-Identifier: MIT
#include "rest/query.h"

#include <algorithm>

namespace slipstitch::rest {
namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end == std::string_view::npos ? end : end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

bool parse_query(std::string_view text, Target& target) {
  for (const std::string_view pair : split(text, '&')) {
    if (pair.empty()) continue;
    const std::size_t equals = std::min(pair.find('='), pair.size());
    std::string value(pair.substr(std::min(equals + 1, pair.size())));
    std::replace(value.begin(), value.end(), '+', ' ');
    const auto name = percent_decoded(pair.substr(0, equals)), decoded = percent_decoded(value);
    if (!name || !decoded) return false;
    target.query.emplace_back(*name, *decoded);
  }
  return true;
}

}  // namespace

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    int byte = static_cast<unsigned char>(text[i]);
    if (text[i] == '%') {
      if (text.size() - i < 3) return std::nullopt;
      const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high < 0 || low < 0) return std::nullopt;
      byte = 16 * high + low;
      i += 2;
    }
    if (byte < 0x20 || byte >= 0x7f) return std::nullopt;  // no name of ours has others
    decoded += static_cast<char>(byte);
  }
  return decoded;
}

std::optional<Target> parse_target(std::string_view target, std::string& why) {
  why = "a target begins with a slash";
  if (!target.starts_with('/')) return std::nullopt;
  const std::size_t mark = std::min(target.find('?'), target.size());
  why = "a target has printable ASCII and complete %XX only";
  Target parsed;
  for (const std::string_view segment : split(target.substr(1, mark - 1), '/')) {
    const std::optional<std::string> decoded = percent_decoded(segment);
    if (!decoded) return std::nullopt;
    parsed.segments.push_back(*decoded);
  }
  if (mark < target.size() && !parse_query(target.substr(mark + 1), parsed)) return std::nullopt;
  why.clear();
  return parsed;
}

}  // namespace slipstitch::rest
