// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

/// As the CPU calls itself; empty where it does not.
std::string cpu_name();

}  // namespace slipstitch
