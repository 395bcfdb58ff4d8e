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

/// Text from outside may be cut inside a character, or be no text at all; what cannot be UTF-8 is replaced.
std::string valid_utf8(const std::string& text);

/// The value as JSON, shortened to about 60 characters, arrays and objects only by kind.
std::string short_text(const JsonNode& node);

/// 1-based; columns count characters.
struct TextPlace {
  int line = 0, column = 0;  // 0: not in the text
};
TextPlace place_of(std::string_view text, std::size_t offset);

/// Places one after the other: goes on from the last where the next is not before it, so that many in order read the
/// text once.
class PlaceFinder {
 public:
  explicit PlaceFinder(std::string_view text) : text_(text) {}
  TextPlace of(std::size_t offset);

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  TextPlace place_{1, 1};  // of it
};

}  // namespace slipstitch
