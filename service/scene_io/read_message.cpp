// SPDX-License-Identifier: MIT
#include "scene_io/read_message.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/unknown_field_set.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "scene_io/nearest_name.h"

namespace slipstitch {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumValueDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::OneofDescriptor;
using google::protobuf::Reflection;

std::vector<std::string> field_names(const Descriptor& type) {
  std::vector<std::string> names;
  for (int i = 0; i < type.field_count(); ++i) names.push_back(type.field(i)->name());
  return names;
}

/// Without the UNSPECIFIED value 0, which no file can mean.
std::vector<std::string> enum_names(const FieldDescriptor& field) {
  std::vector<std::string> names;
  for (int i = 0; i < field.enum_type()->value_count(); ++i) {
    const EnumValueDescriptor& value = *field.enum_type()->value(i);
    if (!value.name().ends_with("_UNSPECIFIED")) names.push_back("\"" + value.name() + "\"");
  }
  return names;
}

/// Protobuf's JSON mapping writes 64-bit integers as texts, because many programs read numbers as doubles.
template <class T>
std::optional<T> whole_number(const std::string& text) {
  T value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional<T>(value) : std::nullopt;
}

class Reader {
 public:
  Reader(std::string_view text, Issues& issues) : places_(text), issues_(issues) {}

  void read(const JsonNode& node, Message& message, const std::string& path) {
    const auto* object = std::get_if<JsonObject>(&node.value);
    if (object == nullptr) return report(path, node, "an object");
    std::map<const OneofDescriptor*, const FieldDescriptor*> chosen;
    for (const JsonMember& member : *object) {
      if (issues_.full()) return;  // a near name takes its time
      const FieldDescriptor* field = message.GetDescriptor()->FindFieldByName(member.key);
      std::string member_path = path.empty() ? member.key : path + "." + member.key;
      if (field == nullptr) {
        report_unknown(member, *message.GetDescriptor(), member_path);
        continue;
      }
      if (const OneofDescriptor* oneof = field->real_containing_oneof()) {
        if (member.key_offset != kNoOffset && is_set(*object, *oneof)) continue;  // instead of the file's choice
        auto [first, fresh] = chosen.emplace(oneof, field);
        if (!fresh) {
          report(member_path, member.key_offset, "a second choice beside \"" + first->second->name() + "\"",
                 "only one of them");
          continue;
        }
      }
      read_field(member.value, message, *field, member_path);
    }
  }

 private:
  /// Whether a setting has chosen a member of the oneof.
  static bool is_set(const JsonObject& object, const OneofDescriptor& oneof) {
    return std::any_of(object.begin(), object.end(), [&](const JsonMember& member) {
      const FieldDescriptor* field = oneof.containing_type()->FindFieldByName(member.key);
      return member.key_offset == kNoOffset && field != nullptr && field->real_containing_oneof() == &oneof;
    });
  }

  void read_field(const JsonNode& node, Message& message, const FieldDescriptor& field, const std::string& path) {
    if (!field.is_repeated()) return read_value(node, message, field, path);
    const auto* array = std::get_if<JsonArray>(&node.value);
    if (array == nullptr) return report(path, node, "an array");
    for (std::size_t i = 0; i < array->size() && !issues_.full(); ++i) {
      read_value((*array)[i], message, field, path + "[" + std::to_string(i) + "]");
    }
  }

  /// Sets a singular field or adds to a repeated one.
  void read_value(const JsonNode& node, Message& message, const FieldDescriptor& field, const std::string& path) {
    const Reflection& to = *message.GetReflection();
    const bool add = field.is_repeated();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_INT32:
        if (auto value = integer<std::int32_t>(node, path)) {
          add ? to.AddInt32(&message, &field, *value) : to.SetInt32(&message, &field, *value);
        }
        return;
      case FieldDescriptor::CPPTYPE_INT64:
        if (auto value = integer<std::int64_t>(node, path)) {
          add ? to.AddInt64(&message, &field, *value) : to.SetInt64(&message, &field, *value);
        }
        return;
      case FieldDescriptor::CPPTYPE_UINT32:
        if (auto value = integer<std::uint32_t>(node, path)) {
          add ? to.AddUInt32(&message, &field, *value) : to.SetUInt32(&message, &field, *value);
        }
        return;
      case FieldDescriptor::CPPTYPE_UINT64:
        if (auto value = integer<std::uint64_t>(node, path)) {
          add ? to.AddUInt64(&message, &field, *value) : to.SetUInt64(&message, &field, *value);
        }
        return;
      case FieldDescriptor::CPPTYPE_DOUBLE:
        if (auto value = number(node, path)) {
          add ? to.AddDouble(&message, &field, *value) : to.SetDouble(&message, &field, *value);
        }
        return;
      case FieldDescriptor::CPPTYPE_FLOAT:
        if (auto value = number(node, path)) {
          auto single = static_cast<float>(*value);
          add ? to.AddFloat(&message, &field, single) : to.SetFloat(&message, &field, single);
        }
        return;
      case FieldDescriptor::CPPTYPE_BOOL:
        if (const auto* value = std::get_if<bool>(&node.value)) {
          add ? to.AddBool(&message, &field, *value) : to.SetBool(&message, &field, *value);
        } else {
          report(path, node, "true or false");
        }
        return;
      case FieldDescriptor::CPPTYPE_ENUM:
        if (const EnumValueDescriptor* value = enum_value(node, field, path)) {
          add ? to.AddEnum(&message, &field, value) : to.SetEnum(&message, &field, value);
        }
        return;
      case FieldDescriptor::CPPTYPE_STRING:
        if (const auto* value = std::get_if<std::string>(&node.value)) {
          add ? to.AddString(&message, &field, *value) : to.SetString(&message, &field, *value);
        } else {
          report(path, node, "a string");
        }
        return;
      case FieldDescriptor::CPPTYPE_MESSAGE:
        read(node, add ? *to.AddMessage(&message, &field) : *to.MutableMessage(&message, &field), path);
        return;
    }
  }

  template <class T>
  std::optional<T> integer(const JsonNode& node, const std::string& path) {
    std::optional<T> value;
    if (const auto* whole = std::get_if<std::int64_t>(&node.value); whole && std::in_range<T>(*whole)) {
      value = static_cast<T>(*whole);
    } else if (const auto* large = std::get_if<std::uint64_t>(&node.value); large && std::in_range<T>(*large)) {
      value = static_cast<T>(*large);
    } else if (const auto* text = std::get_if<std::string>(&node.value); text && sizeof(T) == sizeof(std::int64_t)) {
      value = whole_number<T>(*text);
    }
    if (!value) {
      report(path, node,
             "a whole number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
                 std::to_string(std::numeric_limits<T>::max()));
    }
    return value;
  }

  std::optional<double> number(const JsonNode& node, const std::string& path) {
    if (const auto* real = std::get_if<double>(&node.value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*whole);
    if (const auto* large = std::get_if<std::uint64_t>(&node.value)) return static_cast<double>(*large);
    bool text = std::holds_alternative<std::string>(node.value);
    report(path, node, text ? "a finite number, not a string" : "a finite number");
    return std::nullopt;
  }

  const EnumValueDescriptor* enum_value(const JsonNode& node, const FieldDescriptor& field, const std::string& path) {
    const auto* name = std::get_if<std::string>(&node.value);
    const EnumValueDescriptor* value = name != nullptr ? field.enum_type()->FindValueByName(*name) : nullptr;
    if (value != nullptr && !value->name().ends_with("_UNSPECIFIED")) return value;
    report(path, node, one_of(enum_names(field)));
    return nullptr;
  }

  void report_unknown(const JsonMember& member, const Descriptor& type, const std::string& path) {
    std::vector<std::string> names = field_names(type);
    std::string meant = nearest_name(member.key, names);
    std::string expected = "a field of " + type.name();
    if (!meant.empty()) {
      expected += "; did you mean \"" + meant + "\"?";
    } else if (!names.empty()) {
      expected += ": " + one_of(names);
    } else {
      expected += ", which has none";
    }
    report(path, member.key_offset, "an unknown field", expected);
  }

  void report(const std::string& path, const JsonNode& node, std::string expected) {
    if (std::holds_alternative<std::nullptr_t>(node.value)) expected += "; leave the field out for its default";
    report(path, node.offset, short_text(node), std::move(expected));
  }

  void report(const std::string& path, std::size_t offset, std::string value, std::string expected) {
    if (issues_.full()) return;
    const TextPlace at = places_.of(offset);
    issues_.push_back({path, std::move(value), std::move(expected), false, at.line, at.column});
  }

  PlaceFinder places_;
  Issues& issues_;
};

}  // namespace

void read_message(const JsonNode& root, std::string_view text, Message& message, Issues& issues) {
  Reader(text, issues).read(root, message, "");
}

void find_unknown_fields(const Message& message, const std::string& path, Issues& issues) {
  const Reflection& reflection = *message.GetReflection();
  const auto& unknown = reflection.GetUnknownFields(message);
  for (int i = 0; i < unknown.field_count() && !issues.full(); ++i) {
    issues.push_back({path, "unknown field number " + std::to_string(unknown.field(i).number()),
                      "fields of " + message.GetDescriptor()->name() + " that this version knows"});
  }
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    std::string child = path.empty() ? field->name() : path + "." + field->name();
    if (!field->is_repeated()) {
      find_unknown_fields(reflection.GetMessage(message, field), child, issues);
      continue;
    }
    for (int i = 0; i < reflection.FieldSize(message, field); ++i) {
      find_unknown_fields(reflection.GetRepeatedMessage(message, field, i), child + "[" + std::to_string(i) + "]",
                          issues);
    }
  }
}

}  // namespace slipstitch
