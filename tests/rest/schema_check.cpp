// SPDX-License-Identifier: MIT
#include "schema_check.h"

#include <regex>
#include <set>

namespace slipstitch::test {
namespace {

using Json = nlohmann::json;

bool has_type(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  return type == "integer" ? value.is_number_integer() : type == "number" && value.is_number();
}

std::string object_flaw(const Json& value, const Json& schema, const Json& document) {
  for (const auto& [key, member] : value.items()) {
    const bool known = schema.contains("properties") && schema["properties"].contains(key);
    const Json more = schema.value("additionalProperties", Json(true));
    if (!known && more == false) return "." + key + " is not in the schema";
    if (!known && !more.is_object()) continue;
    const std::string flaw = schema_flaw(member, known ? schema["properties"][key] : more, document);
    if (!flaw.empty()) return "." + key + flaw;
  }
  for (const Json& key : schema.value("required", Json::array())) {
    if (!value.contains(key)) return "." + key.get<std::string>() + " is missing";
  }
  return {};
}

std::string scalar_flaw(const Json& value, const Json& schema) {
  if (schema.contains("enum") &&
      std::find(schema["enum"].begin(), schema["enum"].end(), value) == schema["enum"].end()) {
    return " is " + value.dump() + ", none of " + schema["enum"].dump();
  }
  if (schema.contains("pattern") &&
      !std::regex_search(value.get<std::string>(), std::regex(schema["pattern"].get<std::string>()))) {
    return " is " + value.dump() + ", expected " + schema["pattern"].get<std::string>();
  }
  if (schema.contains("minimum") && value < schema["minimum"]) return " is below the minimum";
  return {};
}

}  // namespace

std::string schema_flaw(const Json& value, const Json& schema, const Json& document) {
  static const std::set<std::string> known{"$ref",        "type",  "format",  "properties", "additionalProperties",
                                           "description", "items", "minimum", "required",   "enum",
                                           "pattern"};
  for (const auto& [keyword, unused] : schema.items()) {
    if (!known.contains(keyword)) return ": keyword " + keyword + " is not checked";
  }
  if (schema.contains("$ref")) {
    return schema_flaw(value, document.at(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))), document);
  }
  const std::string type = schema.value("type", "");
  if (!has_type(value, type)) return " is " + value.dump().substr(0, 60) + ", expected " + type;
  if (type == "object") return object_flaw(value, schema, document);
  if (type != "array") return scalar_flaw(value, schema);
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string flaw = schema_flaw(value[i], schema["items"], document);
    if (!flaw.empty()) return "[" + std::to_string(i) + "]" + flaw;
  }
  return {};
}

}  // namespace slipstitch::test
