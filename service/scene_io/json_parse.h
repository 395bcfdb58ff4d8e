// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "model/issue.h"
#include "scene_io/json_tree.h"

namespace slipstitch {

inline constexpr int kMaxJsonDepth = 64;
/// Values of a document, a text counted as three, an object or array as ten, as that is about the memory it takes when
/// it is read.
inline constexpr long kMaxJsonValues = 8'000'000;

/// Standard JSON, nested at most kMaxJsonDepth deep, of at most kMaxJsonValues, keys unique in each object. A syntax
/// error or too much of either is one issue and no document; duplicate keys are issues beside a document that keeps the
/// first of each.
std::optional<JsonNode> parse_json(std::string_view text, Issues& issues);

}  // namespace slipstitch
