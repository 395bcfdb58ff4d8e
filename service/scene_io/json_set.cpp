// SPDX-License-Identifier: MIT
#include "scene_io/json_set.h"

#include <charconv>
#include <optional>
#include <variant>
#include <vector>

#include "scene_io/json_parse.h"

namespace slipstitch {
namespace {

using Step = std::variant<std::string, std::size_t>;  // member or index

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Nothing when the path is malformed.
std::optional<std::vector<Step>> split_path(std::string_view path) {
  std::vector<Step> steps;
  while (!path.empty()) {
    if (path.front() == '[') {
      std::size_t index = 0;
      auto parsed = std::from_chars(path.data() + 1, path.data() + path.size(), index);
      std::size_t end = static_cast<std::size_t>(parsed.ptr - path.data());
      if (steps.empty() || parsed.ec != std::errc() || end >= path.size() || path[end] != ']') return std::nullopt;
      steps.emplace_back(index);
      path.remove_prefix(end + 1);
      continue;
    }
    if (!steps.empty()) {
      if (path.front() != '.') return std::nullopt;
      path.remove_prefix(1);
    }
    std::size_t end = 0;
    while (end < path.size() && is_name_character(path[end])) ++end;
    if (end == 0) return std::nullopt;
    steps.emplace_back(std::string(path.substr(0, end)));
    path.remove_prefix(end);
  }
  if (steps.empty()) return std::nullopt;
  return steps;
}

/// The child of `node` at `step`, made if it is missing; null when the node is something else or the index too large.
JsonNode* step_into(JsonNode& node, const Step& step) {
  bool fresh = std::holds_alternative<std::nullptr_t>(node.value) && node.offset == kNoOffset;
  if (const auto* name = std::get_if<std::string>(&step)) {
    if (fresh) node.value = JsonObject{};
    auto* object = std::get_if<JsonObject>(&node.value);
    if (object == nullptr) return nullptr;
    if (JsonNode* member = find_member(*object, *name)) return member;
    object->push_back({*name, kNoOffset, {}});
    return &object->back().value;
  }
  if (fresh) node.value = JsonArray{};
  auto* array = std::get_if<JsonArray>(&node.value);
  std::size_t index = std::get<std::size_t>(step);
  if (array == nullptr || index > array->size()) return nullptr;
  if (index == array->size()) array->emplace_back();
  return &(*array)[index];
}

void forget_offsets(JsonNode& node) {
  node.offset = kNoOffset;
  if (auto* array = std::get_if<JsonArray>(&node.value)) {
    for (JsonNode& item : *array) forget_offsets(item);
  } else if (auto* object = std::get_if<JsonObject>(&node.value)) {
    for (JsonMember& member : *object) {
      member.key_offset = kNoOffset;
      forget_offsets(member.value);
    }
  }
}

JsonNode setting_value(const std::string& text) {
  Issues ignored;
  std::optional<JsonNode> node = parse_json(text, ignored);
  if (!node || !ignored.empty()) return {text, kNoOffset};
  forget_offsets(*node);
  return std::move(*node);
}

}  // namespace

void apply_setting(JsonNode& root, const std::string& setting, Issues& issues) {
  std::size_t equals = setting.find('=');
  std::optional<std::vector<Step>> steps = split_path(std::string_view(setting).substr(0, equals));
  if (equals == std::string::npos || !steps) {
    issues.push_back({"", "the setting \"" + setting + "\"", "PATH=VALUE with a path such as handles[0].where.corner"});
    return;
  }
  JsonNode* node = &root;
  for (const Step& step : *steps) {
    node = step_into(*node, step);
    if (node == nullptr) {
      issues.push_back({"", "the setting \"" + setting + "\"",
                        "a path through objects and arrays of the scene; an index may be at most the array's length"});
      return;
    }
  }
  *node = setting_value(setting.substr(equals + 1));
}

}  // namespace slipstitch
