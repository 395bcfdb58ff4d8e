// SPDX-License-Identifier: MIT
#include "rest/json_schema.h"

#include <optional>
#include <string>

namespace slipstitch::rest {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using Json = nlohmann::ordered_json;

// Types that the mapping writes in a way of their own.
std::optional<Json> well_known(const std::string& name) {
  if (name == "google.protobuf.Timestamp") return Json{{"type", "string"}, {"format", "date-time"}};
  if (name == "google.protobuf.Duration") return Json{{"type", "string"}, {"pattern", "^-?[0-9]+(\\.[0-9]+)?s$"}};
  if (name != "google.protobuf.Any") return std::nullopt;
  return Json{{"type", "object"},
              {"description", "ErrorInfo, BadRequest or RetryInfo of google.rpc; @type says which"},
              {"properties", {{"@type", {{"type", "string"}}}}},
              {"required", {"@type"}}};
}

Json enum_schema(const google::protobuf::EnumDescriptor& type) {
  Json names = Json::array();
  for (int i = 0; i < type.value_count(); ++i) names.push_back(type.value(i)->name());
  return {{"type", "string"}, {"enum", std::move(names)}};
}

// 64-bit integers are texts, because JSON's numbers are doubles to many programs.
Json whole_number(bool is_signed, bool wide) {
  const std::string format = std::string(is_signed ? "int" : "uint") + (wide ? "64" : "32");
  Json schema{{"type", wide ? "string" : "integer"}, {"format", format}};
  if (!wide && !is_signed) schema["minimum"] = 0;
  if (wide) schema["pattern"] = is_signed ? "^-?[0-9]+$" : "^[0-9]+$";
  return schema;
}

// "exactly one of" for every choice.
std::string choices(const Descriptor& message) {
  std::string text;
  for (int i = 0; i < message.real_oneof_decl_count(); ++i) {
    const auto& oneof = *message.oneof_decl(i);
    text += (text.empty() ? "At most one of " : "; at most one of ");
    for (int k = 0; k < oneof.field_count(); ++k) text += (k > 0 ? ", " : "") + oneof.field(k)->name();
  }
  return text;
}

}  // namespace

const Descriptor& message_named(std::string_view name) {
  return *google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(std::string(name));
}

Json JsonSchemas::reference(const Descriptor& message) {
  if (auto schema = well_known(message.full_name())) return *schema;
  const std::string name = message.file()->package() == "google.rpc" ? "google.rpc." + message.name() : message.name();
  if (!schemas_.contains(name)) {
    schemas_[name] = nullptr;  // a message may refer to itself
    Json schema = object(message);
    schemas_[name] = std::move(schema);
  }
  return {{"$ref", "#/components/schemas/" + name}};
}

Json JsonSchemas::object(const Descriptor& message) {
  Json schema{{"type", "object"}};
  if (std::string text = choices(message); !text.empty()) schema["description"] = text;
  Json properties = Json::object();
  for (int i = 0; i < message.field_count(); ++i) {
    const FieldDescriptor& field = *message.field(i);
    if (field.is_map()) {
      properties[field.name()] = {{"type", "object"},
                                  {"additionalProperties", value(*field.message_type()->map_value())}};
    } else if (field.is_repeated()) {
      properties[field.name()] = {{"type", "array"}, {"items", value(field)}};
    } else {
      properties[field.name()] = value(field);
    }
  }
  schema["properties"] = std::move(properties);
  schema["additionalProperties"] = false;
  return schema;
}

Json JsonSchemas::value(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      return whole_number(true, false);
    case FieldDescriptor::CPPTYPE_UINT32:
      return whole_number(false, false);
    case FieldDescriptor::CPPTYPE_INT64:
      return whole_number(true, true);
    case FieldDescriptor::CPPTYPE_UINT64:
      return whole_number(false, true);
    case FieldDescriptor::CPPTYPE_DOUBLE:
    case FieldDescriptor::CPPTYPE_FLOAT:
      return {{"type", "number"}};
    case FieldDescriptor::CPPTYPE_BOOL:
      return {{"type", "boolean"}};
    case FieldDescriptor::CPPTYPE_ENUM:
      return enum_schema(*field.enum_type());
    case FieldDescriptor::CPPTYPE_STRING:
      return {{"type", "string"}};
    case FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
  return reference(*field.message_type());
}

}  // namespace slipstitch::rest
