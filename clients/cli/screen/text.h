// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/number_text.h"

namespace slipstitch {

/// "a, b, c" wrapped into lines of at most `width` characters.
std::vector<std::string> wrap_list(const std::vector<std::string>& words, std::size_t width);

/// Two columns, names left; a row without a name goes on with the one before. Values may have several lines.
using Rows = std::vector<std::pair<std::string, std::string>>;
std::string two_columns(const Rows& rows);

/// The words of `text` behind `head`, in lines of at most 78 characters, all but the first indented by three.
std::string wrapped(const std::string& head, const std::string& text);

/// One row a vector, first row the heading; columns as wide as their content.
std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace slipstitch
