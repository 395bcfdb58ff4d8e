// SPDX-License-Identifier: MIT
#include <charconv>
#include <sstream>

#include "support/parsers/curves.h"

namespace slipstitch::test {
namespace {

using Point = std::array<double, 3>;

bool read_point(std::istringstream& words, std::vector<Point>& points) {
  Point point;
  for (double& x : point) {
    std::string word;
    if (!(words >> word)) return false;
    const char* const word_end = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), word_end, x);
    if (error != std::errc() || end != word_end) return false;
  }
  points.push_back(point);
  return true;
}

bool read_line(std::istringstream& words, const std::vector<Point>& points, Curves<double>& result) {
  auto& curve = result.curves.emplace_back();
  long number = 0;
  while (words >> number) {
    if (number < 1 || number > static_cast<long>(points.size())) return false;
    curve.push_back(points[static_cast<std::size_t>(number - 1)]);
  }
  return words.eof() && curve.size() >= 2;
}

}  // namespace

std::optional<Curves<double>> parse_obj(std::string_view text) {
  Curves<double> result;
  std::vector<Point> points;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v" && !read_point(words, points)) return std::nullopt;
    if (keyword == "l" && !read_line(words, points, result)) return std::nullopt;
  }
  return result;
}

}  // namespace slipstitch::test
