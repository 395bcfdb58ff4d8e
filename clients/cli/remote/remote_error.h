// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/support/status.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "google/rpc/status.pb.h"

namespace slipstitch {

/// Why the server did not do it: a gRPC status with the details of google.rpc.Status, where it has any.
struct RemoteError {
  grpc::StatusCode code = grpc::StatusCode::OK;
  std::string reason;  // UPPER_SNAKE; empty: not from Slipstitch (no connection, another server)
  std::string message;
  std::map<std::string, std::string> metadata;
  std::vector<std::pair<std::string, std::string>> violations;  // field, "is VALUE, expected ..."
  std::optional<double> retry_after_s;
};

RemoteError remote_error(const grpc::Status& status);
RemoteError remote_error(const google::rpc::Status& status);

/// For people: the server's own message, or of a connection that failed only the cause, without gRPC's addresses.
std::string plain_text(const RemoteError& error);

/// The call never came through, or the server is going away: the same call may work a moment later.
bool worth_a_retry(const RemoteError& error);

/// A value, or why there is none.
template <class T>
struct Reply {
  std::optional<T> value;
  RemoteError error;
  explicit operator bool() const { return value.has_value(); }
  const T& operator*() const { return *value; }
  const T* operator->() const { return &*value; }
};

}  // namespace slipstitch
