// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/issue.h"

namespace slipstitch {

/// "is -1, expected > 0 (line 3, column 5)"; what is not known is left out.
std::string describe(const Issue& issue);

/// "yarn.radius_m: is -1, expected > 0 (line 3, column 5)".
std::string issue_line(const Issue& issue);

/// One line each.
std::string issue_lines(const Issues& issues);

}  // namespace slipstitch
