// SPDX-License-Identifier: MIT
#include "rest/json_writer.h"

#include <google/protobuf/any.pb.h>
#include <google/protobuf/util/time_util.h>

#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "formats/number_text.h"

namespace slipstitch::rest {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

void append_text(const std::string& value, std::string& text) {
  text += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_double(double value, std::string& text) {
  if (std::isfinite(value)) return append_number(text, value);
  text += std::isnan(value) ? "\"NaN\"" : value > 0.0 ? "\"Infinity\"" : "\"-Infinity\"";
}

void append_enum(const FieldDescriptor& field, int number, std::string& text) {
  const auto* value = field.enum_type()->FindValueByNumber(number);
  text += value != nullptr ? "\"" + value->name() + "\"" : std::to_string(number);
}

/// Of a singular field, or of element `i` of a repeated one.
void append_value(const Message& message, const FieldDescriptor& field, int i, std::string& text) {
  const Reflection& from = *message.GetReflection();
  const bool one = !field.is_repeated();
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT32:
      text += std::to_string(one ? from.GetInt32(message, &field) : from.GetRepeatedInt32(message, &field, i));
      return;
    case FieldDescriptor::CPPTYPE_UINT32:
      text += std::to_string(one ? from.GetUInt32(message, &field) : from.GetRepeatedUInt32(message, &field, i));
      return;
    case FieldDescriptor::CPPTYPE_INT64:
      text += '"';
      text += std::to_string(one ? from.GetInt64(message, &field) : from.GetRepeatedInt64(message, &field, i)) + '"';
      return;
    case FieldDescriptor::CPPTYPE_UINT64:
      text += '"';
      text += std::to_string(one ? from.GetUInt64(message, &field) : from.GetRepeatedUInt64(message, &field, i)) + '"';
      return;
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return append_double(one ? from.GetDouble(message, &field) : from.GetRepeatedDouble(message, &field, i), text);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return append_double(
          static_cast<double>(one ? from.GetFloat(message, &field) : from.GetRepeatedFloat(message, &field, i)), text);
    case FieldDescriptor::CPPTYPE_BOOL:
      text += (one ? from.GetBool(message, &field) : from.GetRepeatedBool(message, &field, i)) ? "true" : "false";
      return;
    case FieldDescriptor::CPPTYPE_ENUM:
      return append_enum(
          field, one ? from.GetEnumValue(message, &field) : from.GetRepeatedEnumValue(message, &field, i), text);
    case FieldDescriptor::CPPTYPE_STRING:
      return append_text(one ? from.GetString(message, &field) : from.GetRepeatedString(message, &field, i), text);
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return append_json(one ? from.GetMessage(message, &field) : from.GetRepeatedMessage(message, &field, i), text);
  }
}

void append_list(const Message& message, const FieldDescriptor& field, std::string& text) {
  text += '[';
  const int size = message.GetReflection()->FieldSize(message, &field);
  for (int i = 0; i < size; ++i) {
    if (i > 0) text += ',';
    append_value(message, field, i, text);
  }
  text += ']';
}

/// Keys of ours are texts; sorted, so that equal messages give equal text.
void append_map(const Message& message, const FieldDescriptor& field, std::string& text) {
  const Descriptor& entry = *field.message_type();
  std::map<std::string, std::string> values;
  for (int i = 0; i < message.GetReflection()->FieldSize(message, &field); ++i) {
    const Message& pair = message.GetReflection()->GetRepeatedMessage(message, &field, i);
    append_value(pair, *entry.map_value(), 0, values[pair.GetReflection()->GetString(pair, entry.map_key())]);
  }
  text += '{';
  for (const auto& [key, value] : values) {
    if (text.back() != '{') text += ',';
    append_text(key, text);
    text += ':' + value;
  }
  text += '}';
}

/// Members of an object; `text` ends with its brace, or with a member.
void append_fields(const Message& message, std::string& text) {
  const Descriptor& type = *message.GetDescriptor();
  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (field.has_presence() && !message.GetReflection()->HasField(message, &field)) continue;
    if (text.back() != '{') text += ',';
    text += "\"" + field.name() + "\":";
    if (field.is_map()) {
      append_map(message, field, text);
    } else if (field.is_repeated()) {
      append_list(message, field, text);
    } else {
      append_value(message, field, 0, text);
    }
  }
}

void append_any(const google::protobuf::Any& any, std::string& text) {
  const std::string name = any.type_url().substr(any.type_url().rfind('/') + 1);
  text += "{\"@type\":";
  append_text(any.type_url(), text);
  if (const Descriptor* type = google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(name)) {
    const std::unique_ptr<Message> packed(
        google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
    if (packed->ParseFromString(any.value())) append_fields(*packed, text);
  }
  text += '}';
}

}  // namespace

void append_json(const Message& message, std::string& text) {
  using google::protobuf::util::TimeUtil;
  if (const auto* any = dynamic_cast<const google::protobuf::Any*>(&message)) return append_any(*any, text);
  if (const auto* time = dynamic_cast<const google::protobuf::Timestamp*>(&message)) {
    return append_text(TimeUtil::ToString(*time), text);
  }
  if (const auto* duration = dynamic_cast<const google::protobuf::Duration*>(&message)) {
    return append_text(TimeUtil::ToString(*duration), text);
  }
  text += '{';
  append_fields(message, text);
  text += '}';
}

}  // namespace slipstitch::rest
