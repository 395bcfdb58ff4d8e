// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/message.h>

#include <string>

namespace slipstitch {

/// SHA-256 of the deterministic serialisation, lower-case hex (64 characters). Hash a message from
/// message_from_scene(), so that a default and the same value written out count as equal.
std::string message_hash(const google::protobuf::Message& message);

}  // namespace slipstitch
