// SPDX-License-Identifier: MIT
#include "cli/remote/remote_error.h"

#include <gtest/gtest.h>

namespace slipstitch::test {
namespace {

RemoteError error(grpc::StatusCode code, const std::string& message) {
  return remote_error(grpc::Status(code, message));
}

TEST(RemoteError, ABrokenConnectionIsToldByItsCauseAlone) {
  const std::string raw =
      "failed to connect to all addresses; last error: UNKNOWN: ipv4:127.0.0.1:1: Failed to connect to remote host: "
      "Connection refused";
  EXPECT_EQ(plain_text(error(grpc::StatusCode::UNAVAILABLE, raw)), "Connection refused");
  EXPECT_EQ(plain_text(error(grpc::StatusCode::UNAVAILABLE, "Socket closed")), "Socket closed");
  EXPECT_EQ(plain_text(error(grpc::StatusCode::NOT_FOUND, "there is no: job")), "there is no: job");
  RemoteError stopping = error(grpc::StatusCode::UNAVAILABLE, "the server is stopping: later");
  stopping.reason = "SERVER_STOPPING";
  EXPECT_EQ(plain_text(stopping), "the server is stopping: later");
}

// As gRPC answers calls that reach a server after its streams have ended.
TEST(RemoteError, ACallThatTheServerCancelledIsALostServer) {
  const RemoteError lost = error(grpc::StatusCode::CANCELLED, "CANCELLED");
  EXPECT_EQ(lost.code, grpc::StatusCode::UNAVAILABLE);
  EXPECT_TRUE(worth_a_retry(lost));
  EXPECT_EQ(plain_text(lost), "the server ended the call");
}

}  // namespace
}  // namespace slipstitch::test
