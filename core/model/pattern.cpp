// SPDX-License-Identifier: MIT
#include "model/pattern.h"

#include <algorithm>
#include <array>
#include <optional>

namespace slipstitch {
namespace {

constexpr int kSmallest = 2;
constexpr long kMostCells = 100'000'000;  // an absolute cap, so that no size overflows; scenes have lower limits

std::string row_path(const std::string& path, std::size_t row) { return path + "[" + std::to_string(row) + "]"; }

std::optional<StitchKind> kind_of(char letter) {
  if (letter == 'K' || letter == 'k') return StitchKind::knit;
  if (letter == 'P' || letter == 'p') return StitchKind::purl;
  return std::nullopt;
}

StitchKind other(StitchKind kind) { return kind == StitchKind::knit ? StitchKind::purl : StitchKind::knit; }

// The letters of one text line; unknown ones are reported and read as knit.
std::vector<StitchKind> parse_row(const std::string& row, const std::string& path, Issues& issues) {
  std::vector<StitchKind> kinds;
  kinds.reserve(row.size());
  for (std::size_t i = 0; i < row.size() && !issues.full(); ++i) {
    const auto kind = kind_of(row[i]);
    if (!kind) {
      issues.push_back({path, std::string(1, row[i]) + " in column " + std::to_string(i + 1), "K or P", false});
    }
    kinds.push_back(kind.value_or(StitchKind::knit));
  }
  return kinds;
}

// Equal lengths and at least 2 x 2. Every row that differs from the first is named.
void check_shape(const std::vector<std::string>& rows, const std::string& path, Issues& issues) {
  if (rows.size() < kSmallest) {
    issues.push_back({path, std::to_string(rows.size()) + " rows", "at least 2 rows", false});
  }
  for (std::size_t r = 0; r < rows.size() && !issues.full(); ++r) {
    const std::string length = std::to_string(rows[r].size()) + " stitches";
    if (rows[r].size() != rows[0].size()) {
      const std::string wanted = std::to_string(rows[0].size()) + " stitches, as in row 0";
      issues.push_back({row_path(path, r), length, wanted, false});
    } else if (rows[r].size() < kSmallest) {
      issues.push_back({row_path(path, r), length, "at least 2 stitches", false});
    }
  }
}

// Rows in the order given; `bottom_first` false: the last one is course 1.
Pattern from_rows(const std::vector<std::string>& rows, bool in_the_round, bool bottom_first, const std::string& path,
                  Issues& issues) {
  const std::size_t before = issues.size();
  check_shape(rows, path, issues);
  std::vector<std::vector<StitchKind>> kinds;
  for (std::size_t r = 0; r < rows.size() && !issues.full(); ++r) {
    kinds.push_back(parse_row(rows[r], row_path(path, r), issues));
  }
  if (issues.full() || issues.size() != before) return {};
  if (!bottom_first) std::reverse(kinds.begin(), kinds.end());

  Pattern pattern{static_cast<int>(rows.size()), static_cast<int>(rows[0].size()), in_the_round, {}};
  for (const auto& row : kinds) pattern.cells.insert(pattern.cells.end(), row.begin(), row.end());
  return pattern;
}

bool preset_is_knit(const PresetSpec& preset, int course, int wale) {
  if (preset.name == "stockinette") return true;
  if (preset.name == "reverse_stockinette") return false;
  if (preset.name == "garter") return course % 2 == 1;
  if (preset.name == "seed") return (course + wale) % 2 == 0;
  return (wale - 1) % (preset.rib_knits + preset.rib_purls) < preset.rib_knits;  // rib
}

void check_preset(const PresetSpec& preset, const std::string& path, Issues& issues) {
  constexpr std::array kNames{"stockinette", "reverse_stockinette", "garter", "rib", "seed"};
  if (std::find(kNames.begin(), kNames.end(), preset.name) == kNames.end()) {
    issues.push_back({path + ".name", preset.name, "stockinette, reverse_stockinette, garter, rib or seed", false});
  }
  const auto at_least = [&](const char* field, int value, int smallest) {
    if (value < smallest) {
      issues.push_back({path + "." + field, std::to_string(value), "at least " + std::to_string(smallest), false});
    }
  };
  at_least("courses", preset.courses, kSmallest);
  at_least("wales", preset.wales, kSmallest);
  if (preset.name == "rib") {
    at_least("rib_knits", preset.rib_knits, 1);
    at_least("rib_purls", preset.rib_purls, 1);
    constexpr int kWidest = 1'000'000;
    if (preset.rib_knits > kWidest)
      issues.push_back({path + ".rib_knits", std::to_string(preset.rib_knits), "at most 1000000", true});
    if (preset.rib_purls > kWidest)
      issues.push_back({path + ".rib_purls", std::to_string(preset.rib_purls), "at most 1000000", true});
  }
  const long cells = static_cast<long>(preset.courses) * preset.wales;
  if (preset.courses > 0 && preset.wales > 0 && cells > kMostCells) {
    issues.push_back({path, std::to_string(cells) + " stitches", "at most " + std::to_string(kMostCells), true});
  }
}

// Smallest p >= 1 so that line i equals line i + p wherever both exist.
template <class Same>
int smallest_period(int lines, const Same& same) {
  for (int p = 1; p < lines; ++p) {
    bool repeats = true;
    for (int i = 1; i + p <= lines && repeats; ++i) repeats = same(i, i + p);
    if (repeats) return p;
  }
  return lines;
}

}  // namespace

Pattern pattern_from_chart(const std::vector<std::string>& rows, bool in_the_round, const std::string& path,
                           Issues& issues) {
  return from_rows(rows, in_the_round, false, path, issues);
}

Pattern pattern_from_preset(const PresetSpec& preset, bool in_the_round, const std::string& path, Issues& issues) {
  const std::size_t before = issues.size();
  check_preset(preset, path, issues);
  if (issues.full() || issues.size() != before) return {};
  Pattern pattern{preset.courses, preset.wales, in_the_round, {}};
  for (int course = 1; course <= preset.courses; ++course) {
    for (int wale = 1; wale <= preset.wales; ++wale) {
      pattern.cells.push_back(preset_is_knit(preset, course, wale) ? StitchKind::knit : StitchKind::purl);
    }
  }
  return pattern;
}

Pattern pattern_from_worked_rows(const std::vector<std::string>& rows, bool in_the_round, const std::string& path,
                                 Issues& issues) {
  Pattern pattern = from_rows(rows, in_the_round, true, path, issues);
  for (int course = 1; course <= pattern.courses; ++course) {
    const auto first = pattern.cells.begin() + static_cast<std::ptrdiff_t>(course - 1) * pattern.wales;
    const auto last = first + pattern.wales;
    const bool wrong_side = !in_the_round && course % 2 == 0;
    if (wrong_side) {
      std::transform(first, last, first, other);  // worked from the left edge, seen from the right side
    } else {
      std::reverse(first, last);  // worked from the right edge
    }
  }
  return pattern;
}

Repeat smallest_repeat(const Pattern& pattern) {
  Repeat repeat;
  repeat.courses = smallest_period(pattern.courses, [&](int a, int b) {
    for (int w = 1; w <= pattern.wales; ++w) {
      if (pattern.at(a, w) != pattern.at(b, w)) return false;
    }
    return true;
  });
  repeat.wales = smallest_period(pattern.wales, [&](int a, int b) {
    for (int c = 1; c <= pattern.courses; ++c) {
      if (pattern.at(c, a) != pattern.at(c, b)) return false;
    }
    return true;
  });
  return repeat;
}

}  // namespace slipstitch
