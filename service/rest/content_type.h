// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace slipstitch::rest {

/// By the extension of a file name; application/octet-stream for what is not in the list.
std::string_view content_type_of(std::string_view file_name);

}  // namespace slipstitch::rest
