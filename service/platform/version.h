// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

/// "0.1.0".
std::string version_string();

/// What `--version` prints: "NAME 0.1.0 (OpenBLAS SkylakeX, 1 thread)".
std::string version_line(const std::string& program);

}  // namespace slipstitch
