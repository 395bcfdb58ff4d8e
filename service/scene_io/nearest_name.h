// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace slipstitch {

/// What a writer of `name` probably meant: the spelling that differs only in case and underscores, else the nearest by
/// edit distance if it is near; empty if none is.
std::string nearest_name(std::string_view name, const std::vector<std::string>& known);

/// "a, b or c".
std::string one_of(const std::vector<std::string>& names);

}  // namespace slipstitch
