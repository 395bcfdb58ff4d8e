// SPDX-License-Identifier: MIT
#include "rest/api_json.h"

#include "rest/json_writer.h"
#include "scene_io/json_parse.h"
#include "scene_io/read_message.h"

namespace slipstitch::rest {

std::string api_json(const google::protobuf::Message& message) {
  std::string text;
  append_json(message, text);
  return text;
}

ReadRequest read_create_request(std::string_view body) {
  ReadRequest read;
  const std::optional<JsonNode> root = parse_json(body, read.issues);
  read.malformed = !root || !std::holds_alternative<JsonObject>(root->value);
  if (root) read_message(*root, body, read.request, read.issues);
  for (Issue& issue : read.issues) {
    if (issue.path.empty()) issue.path = "request";
  }
  return read;
}

}  // namespace slipstitch::rest
