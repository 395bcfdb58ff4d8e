// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

std::string thousands(long count);                       // 12,345
std::string short_number(double value, int digits = 3);  // significant digits, no trailing zeros
std::string plain_number(double value, int digits = 3);  // the same, but never with an exponent
std::string metres_text(double metres);                  // 1.24 mm, 37 um
std::string bytes_text(double bytes);                    // 1.3 GB
std::string duration_text(double seconds);               // 4.2 s, 2 min 41 s, 1 h 04 min
std::string clock_text(double seconds);                  // 0:07, 12:34, 1:02:03
std::string percent_text(double share);                  // 1.2 %
std::string count_of(long count, const std::string& one, const std::string& many);  // "1 frame", "61 frames"

}  // namespace slipstitch
