// SPDX-License-Identifier: MIT
#include "cli/remote/connection.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

#include "cli/remote/address.h"

namespace slipstitch {
namespace {

constexpr int kReconnect_ms = 200, kMaxReconnect_ms = 2'000;  // between attempts
constexpr int kAttempt_ms = 10'000;  // a server or this machine may be busy, or far away
constexpr int kPing_ms = 20'000;  // notices a machine that vanished; servers allow one every 10 s

grpc::ChannelArguments channel_arguments(const std::string& address) {
  grpc::ChannelArguments arguments;
  if (is_loopback(address)) arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, kReconnect_ms);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, kAttempt_ms);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, kMaxReconnect_ms);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, kPing_ms);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kPing_ms);
  return arguments;
}

}  // namespace

Connection::Connection(std::string address) : address_(std::move(address)) {
  const auto channel =
      grpc::CreateCustomChannel(address_, grpc::InsecureChannelCredentials(), channel_arguments(address_));
  jobs_ = v1::SimJobs::NewStub(channel);
  frames_ = v1::Frames::NewStub(channel);
}

}  // namespace slipstitch
