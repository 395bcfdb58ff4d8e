// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

/// An HTML page that loads nothing, up to its heading.
std::string page_begin(const std::string& title);
std::string page_end();

}  // namespace slipstitch
