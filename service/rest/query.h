// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slipstitch::rest {

/// Undoes %XX. Empty: a broken escape, or a control character.
std::optional<std::string> percent_decoded(std::string_view text);

/// Parts of a target; decoded.
struct Target {
  std::vector<std::string> segments;  // of the path, behind its leading slash
  std::vector<std::pair<std::string, std::string>> query;
};

/// Empty: not a path of ours, and `why` says why.
std::optional<Target> parse_target(std::string_view target, std::string& why);

}  // namespace slipstitch::rest
