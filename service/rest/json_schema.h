// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>

namespace slipstitch::rest {

/// JSON schemas of messages as protobuf's JSON mapping writes them, by name, with those that they refer to.
class JsonSchemas {
 public:
  /// A reference to the schema of a message, "#/components/schemas/SimJob", which is added where it is new.
  nlohmann::ordered_json reference(const google::protobuf::Descriptor& message);

  /// All added so far.
  const nlohmann::ordered_json& all() const { return schemas_; }

 private:
  nlohmann::ordered_json object(const google::protobuf::Descriptor& message);
  nlohmann::ordered_json value(const google::protobuf::FieldDescriptor& field);

  nlohmann::ordered_json schemas_ = nlohmann::ordered_json::object();
};

/// By full name, which must be one of the schema.
const google::protobuf::Descriptor& message_named(std::string_view name);

}  // namespace slipstitch::rest
