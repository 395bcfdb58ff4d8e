// SPDX-License-Identifier: MIT
#include "scene_io/json_tree.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "model/issue.h"

namespace slipstitch {
namespace {

/// Takes the first step of a path, ".name" or "[n]", off `path`.
std::string_view take_step(std::string_view& path) {
  std::size_t end = path.find_first_of(".[", path.empty() ? 0 : 1);
  if (end == std::string_view::npos) end = path.size();
  std::string_view step = path.substr(0, end);
  path.remove_prefix(end);
  return step;
}

const JsonNode* child_at(const JsonNode& node, std::string_view step) {
  if (step.starts_with('[')) {
    const auto* array = std::get_if<JsonArray>(&node.value);
    std::size_t index = 0;
    auto parsed = std::from_chars(step.data() + 1, step.data() + step.size(), index);
    if (array == nullptr || parsed.ec != std::errc() || index >= array->size()) return nullptr;
    return &(*array)[index];
  }
  if (step.starts_with('.')) step.remove_prefix(1);
  const auto* object = std::get_if<JsonObject>(&node.value);
  if (object == nullptr) return nullptr;
  for (const JsonMember& member : *object) {
    if (member.key == step) return &member.value;
  }
  return nullptr;
}

constexpr std::size_t kShown = 60;  // of a value [byte]

struct ShortText {
  std::string operator()(std::nullptr_t) const { return "null"; }
  std::string operator()(const JsonArray& array) const { return "an array of " + std::to_string(array.size()); }
  std::string operator()(const JsonObject&) const { return "an object"; }
  std::string operator()(const std::string& text) const { return nlohmann::json(shortened(text, kShown + 4)).dump(); }
  template <class T>
  std::string operator()(const T& scalar) const {
    return nlohmann::json(scalar).dump();
  }
};

}  // namespace

JsonNode* find_member(JsonObject& object, const std::string& key) {
  for (JsonMember& member : object) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

const JsonNode& nearest_node(const JsonNode& root, const std::string& path) {
  const JsonNode* node = &root;
  std::string_view rest = path;
  while (!rest.empty()) {
    const JsonNode* child = child_at(*node, take_step(rest));
    if (child == nullptr) break;
    node = child;
  }
  return *node;
}

std::string valid_utf8(const std::string& text) {
  std::string quoted = nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return nlohmann::json::parse(quoted).get<std::string>();
}

std::string short_text(const JsonNode& node) { return shortened(std::visit(ShortText{}, node.value), kShown); }

TextPlace place_of(std::string_view text, std::size_t offset) { return PlaceFinder(text).of(offset); }

TextPlace PlaceFinder::of(std::size_t offset) {
  if (offset == kNoOffset) return {};
  if (offset < offset_) *this = PlaceFinder(text_);
  for (const char c : text_.substr(offset_, offset - offset_)) {
    if (c == '\n') {
      ++place_.line;
      place_.column = 1;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {  // not a continuation byte of UTF-8
      ++place_.column;
    }
  }
  offset_ = std::min(offset, text_.size());
  return place_;
}

}  // namespace slipstitch
