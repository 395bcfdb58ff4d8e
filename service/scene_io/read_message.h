// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/message.h>

#include <string>
#include <string_view>

#include "model/issue.h"
#include "scene_io/json_tree.h"

namespace slipstitch {

/// Fills an empty message from a document, strictly: names as in the schema, no null, numbers as numbers, whole numbers
/// for integers (those of 64 bits also as texts), enums by name, one member per oneof. Every problem is appended with
/// its path and its place in `text`.
void read_message(const JsonNode& root, std::string_view text, google::protobuf::Message& message, Issues& issues);

/// Fields that a message carries but this schema does not know: a newer client. Paths of their parents.
void find_unknown_fields(const google::protobuf::Message& message, const std::string& path, Issues& issues);

}  // namespace slipstitch
