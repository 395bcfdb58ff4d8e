// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/message.h>

#include <nlohmann/json.hpp>
#include <string>

namespace slipstitch {

/// A message as JSON: field names as in the schema, in the order of their numbers, absent fields left out, numbers as
/// numbers, enums by name. Equal messages give equal text; read_message() reads it back bit for bit.
nlohmann::ordered_json json_from_message(const google::protobuf::Message& message);

/// The text of a scene file, ending with a newline.
std::string json_text(const google::protobuf::Message& message);

}  // namespace slipstitch
