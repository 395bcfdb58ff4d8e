// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/support/status.h>

#include "api/rpc_status.h"

namespace slipstitch {

/// With the google.rpc.Status of api/rpc_status.h as details.
grpc::Status grpc_status(const jobs::Error& error);

}  // namespace slipstitch
