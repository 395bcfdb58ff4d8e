// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "model/issue.h"
#include "scene_io/json_tree.h"

namespace slipstitch {

inline constexpr int kMaxJsonDepth = 64;

/// Standard JSON, nested at most kMaxJsonDepth deep, keys unique in each object. A syntax error or too much depth is
/// one issue and no document; duplicate keys are issues beside a document that keeps the first of each.
std::optional<JsonNode> parse_json(std::string_view text, Issues& issues);

}  // namespace slipstitch
