// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <string>
#include <vector>

namespace slipstitch::test {

/// Encoded messages of services whose schema the tests do not have.
inline grpc::ByteBuffer raw_message(const std::string& text) {
  const grpc::Slice slice(text);
  return {&slice, 1};
}

inline std::string text_of(const grpc::ByteBuffer& buffer) {
  std::vector<grpc::Slice> slices;
  std::string result;
  if (buffer.Valid() && buffer.Dump(&slices).ok()) {
    for (const grpc::Slice& slice : slices) result.append(slice.begin(), slice.end());
  }
  return result;
}

}  // namespace slipstitch::test
