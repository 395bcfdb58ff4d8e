// SPDX-License-Identifier: MIT
#include "scene_io/json_parse.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>

namespace slipstitch {
namespace {

/// Input of the parser that tells how far it has read.
struct TrackedInput {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* at = nullptr;
  const char** read_to = nullptr;

  reference operator*() const { return *at; }
  TrackedInput& operator++() {
    ++at;
    *read_to = at;
    return *this;
  }
  TrackedInput operator++(int) {
    TrackedInput before = *this;
    ++*this;
    return before;
  }
  bool operator==(const TrackedInput& other) const { return at == other.at; }
  bool operator!=(const TrackedInput& other) const { return at != other.at; }
};

/// Receives the parser's events and builds the tree.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, Issues& issues)
      : text_(text), places_(text), issues_(issues), read_to_(text.data()), last_event_(text.data()) {}

  TrackedInput begin() { return {text_.data(), &read_to_}; }
  TrackedInput end() { return {text_.data() + text_.size(), &read_to_}; }
  JsonNode take_root() { return std::move(root_); }

  bool null() { return put(nullptr); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(std::int64_t value) { return put(value); }
  bool number_unsigned(std::uint64_t value) {
    if (value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
      return put(static_cast<std::int64_t>(value));
    }
    return put(value);
  }
  bool number_float(double value, const std::string&) { return put(value); }
  bool string(std::string& value) { return put(std::move(value)) && count(2); }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // not in JSON text
  bool start_object(std::size_t) { return open(JsonObject{}); }
  bool start_array(std::size_t) { return open(JsonArray{}); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    Level& level = levels_.back();
    auto& object = std::get<JsonObject>(level.node->value);
    std::size_t offset = event_offset();
    if (!level.keys.insert(name).second) {
      object.push_back({std::move(name), offset, {}});
      if (!issues_.full()) report(path(), "\"" + object.back().key + "\"", "each key once in an object", offset);
      level.drop_value = true;
      return true;
    }
    object.push_back({std::move(name), offset, {}});
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token, const nlohmann::detail::exception& error) {
    std::string what = error.what();
    what.erase(0, what.find("] ") + 2);  // the library's own name of the error
    if (what.starts_with("parse error at ")) what.erase(0, what.find(": ") + 2);
    std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
    report(path(), last_token.substr(0, 60), "valid JSON: " + what, offset);
    return false;
  }

 private:
  struct Level {
    JsonNode* node = nullptr;
    std::unordered_set<std::string> keys;
    bool drop_value = false;  // the next value belongs to a duplicate key
  };

  /// Offset of the token of this event: what lies between two tokens is blank or punctuation.
  std::size_t event_offset() {
    const char* end = text_.data() + text_.size();
    const char* start = std::find_if(
        last_event_, end, [](char c) { return std::string_view(" \t\r\n,:").find(c) == std::string_view::npos; });
    last_event_ = read_to_;
    return static_cast<std::size_t>(start - text_.data());
  }

  template <class T>
  JsonNode* place(T&& value) {
    JsonNode node{std::forward<T>(value), event_offset()};
    if (levels_.empty()) {
      root_ = std::move(node);
      return &root_;
    }
    if (auto* array = std::get_if<JsonArray>(&levels_.back().node->value)) {
      array->push_back(std::move(node));
      return &array->back();
    }
    JsonNode& slot = std::get<JsonObject>(levels_.back().node->value).back().value;
    slot = std::move(node);
    return &slot;
  }

  template <class T>
  bool put(T&& value) {
    place(std::forward<T>(value));
    drop_duplicate();
    return count(1);
  }

  template <class T>
  bool open(T&& empty) {
    JsonNode* node = place(std::forward<T>(empty));
    if (levels_.size() == kMaxJsonDepth) {
      report(path(1), "nested deeper than " + std::to_string(kMaxJsonDepth),
             "at most " + std::to_string(kMaxJsonDepth) + " levels of objects and arrays", node->offset);
      return false;
    }
    levels_.push_back({node, {}, false});
    return count(10);
  }

  bool count(long values) {
    values_ += values;
    if (values_ <= kMaxJsonValues) return true;
    const TextPlace at = places_.of(static_cast<std::size_t>(read_to_ - text_.data()));
    issues_.push_back({path(1), "too many values", "at most " + std::to_string(kMaxJsonValues) + " values", true,
                       at.line, at.column, kMaxJsonValues});
    return false;
  }

  bool close() {
    event_offset();
    levels_.pop_back();
    drop_duplicate();
    return true;
  }

  void drop_duplicate() {
    if (levels_.empty() || !levels_.back().drop_value) return;
    std::get<JsonObject>(levels_.back().node->value).pop_back();
    levels_.back().drop_value = false;
  }

  /// Of the value being read, or of the first part of it.
  std::string path(std::size_t max_levels = kMaxJsonDepth) const {
    std::string text;
    for (std::size_t i = 0; i < std::min(levels_.size(), max_levels); ++i) {
      const JsonNode& node = *levels_[i].node;
      if (const auto* array = std::get_if<JsonArray>(&node.value)) {
        text += "[" + std::to_string(array->empty() ? 0 : array->size() - 1) + "]";
      } else if (const auto& object = std::get<JsonObject>(node.value); !object.empty()) {
        text += (text.empty() ? "" : ".") + object.back().key;
      }
    }
    return text;
  }

  void report(std::string where, std::string value, std::string expected, std::size_t offset) {
    const TextPlace at = places_.of(offset);
    issues_.push_back({std::move(where), std::move(value), std::move(expected), false, at.line, at.column});
  }

  std::string_view text_;
  PlaceFinder places_;
  Issues& issues_;
  const char* read_to_;     // first byte the parser has not read
  const char* last_event_;  // read_to_ at the previous event
  JsonNode root_;
  std::vector<Level> levels_;
  long values_ = 0;
};

}  // namespace

std::optional<JsonNode> parse_json(std::string_view text, Issues& issues) {
  TreeBuilder builder(text, issues);
  if (!nlohmann::json::sax_parse(builder.begin(), builder.end(), &builder)) return std::nullopt;
  return builder.take_root();
}

}  // namespace slipstitch
