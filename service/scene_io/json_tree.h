// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace slipstitch {

struct JsonNode;
struct JsonMember;
using JsonArray = std::vector<JsonNode>;
using JsonObject = std::vector<JsonMember>;  // in file order

/// Not from the text: it has no place there.
inline constexpr std::size_t kNoOffset = std::numeric_limits<std::size_t>::max();

/// A JSON value that knows where it stood. Unsigned only above the signed range.
struct JsonNode {
  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, JsonArray, JsonObject> value;
  std::size_t offset = kNoOffset;  // of its first byte
};

struct JsonMember {
  std::string key;
  std::size_t key_offset = kNoOffset;
  JsonNode value;
};

JsonNode* find_member(JsonObject& object, const std::string& key);

/// The node at a path such as "handles[0].where"; of a path that goes on below the document, the deepest node there is.
const JsonNode& nearest_node(const JsonNode& root, const std::string& path);

/// At most `longest` bytes of UTF-8, then "..." if there was more.
std::string shortened(const std::string& text, std::size_t longest);

/// The value as JSON, shortened to about 60 characters, arrays and objects only by kind.
std::string short_text(const JsonNode& node);

/// 1-based; columns count characters.
struct TextPlace {
  int line = 0, column = 0;  // 0: not in the text
};
TextPlace place_of(std::string_view text, std::size_t offset);

}  // namespace slipstitch
