// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace slipstitch::rest {

/// Appends a message in protobuf's JSON mapping, straight to the text: protobuf's own printer builds a tree of it
/// first, which takes a hundred times the memory of a large frame header. Not for messages with `bytes`.
void append_json(const google::protobuf::Message& message, std::string& text);

}  // namespace slipstitch::rest
