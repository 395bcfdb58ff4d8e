// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/sync_stream.h>

#include <memory>
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

/// Health of the server as a whole, now and at every change. HealthCheckResponse.status is field 1, SERVING = 1,
/// NOT_SERVING = 2.
inline std::unique_ptr<grpc::ClientReader<grpc::ByteBuffer>> watch_health(grpc::ChannelInterface& channel,
                                                                          grpc::ClientContext& context) {
  const grpc::internal::RpcMethod watch("/grpc.health.v1.Health/Watch", grpc::internal::RpcMethod::SERVER_STREAMING);
  return std::unique_ptr<grpc::ClientReader<grpc::ByteBuffer>>(
      grpc::internal::ClientReaderFactory<grpc::ByteBuffer>::Create(&channel, watch, &context, raw_message("")));
}
inline constexpr char kServing[] = "\x08\x01", kNotServing[] = "\x08\x02";

}  // namespace slipstitch::test
