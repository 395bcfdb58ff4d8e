// SPDX-License-Identifier: MIT
#include "grpc/status.h"

namespace slipstitch {

grpc::Status grpc_status(const jobs::Error& error) {
  const google::rpc::Status status = rpc_status(error);
  return {static_cast<grpc::StatusCode>(status.code()), status.message(), status.SerializeAsString()};
}

}  // namespace slipstitch
