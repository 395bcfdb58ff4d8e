// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/zero_copy_stream.h>

namespace slipstitch {

/// Whether a message, not yet read, holds at most so many values: a text counted as three, a message as ten, as that is
/// about the memory it takes when it is read. What is no such message is for its reader to refuse.
bool holds_at_most(long values, const google::protobuf::Descriptor& type,
                   google::protobuf::io::ZeroCopyInputStream& bytes);

}  // namespace slipstitch
