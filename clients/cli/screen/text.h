// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slipstitch {

std::string thousands(long count);                       // 12,345
std::string short_number(double value, int digits = 3);  // significant digits, no trailing zeros
std::string metres_text(double metres);                  // 1.24 mm, 37 um
std::string bytes_text(double bytes);                    // 1.3 GB
std::string duration_text(double seconds);               // 4.2 s, 2 min 41 s, 1 h 04 min
std::string clock_text(double seconds);                  // 0:07, 12:34, 1:02:03
std::string percent_text(double share);                  // 1.2 %
std::string count_of(long count, const std::string& one, const std::string& many);  // "1 frame", "61 frames"

/// "a, b, c" wrapped into lines of at most `width` characters.
std::vector<std::string> wrap_list(const std::vector<std::string>& words, std::size_t width);

/// Two columns, names left; a row without a name goes on with the one before. Values may have several lines.
using Rows = std::vector<std::pair<std::string, std::string>>;
std::string two_columns(const Rows& rows);

/// One row a vector, first row the heading; columns as wide as their content.
std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace slipstitch
