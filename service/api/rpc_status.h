// SPDX-License-Identifier: MIT
#pragma once

#include "google/rpc/status.pb.h"
#include "jobs/error.h"
#include "jobs/job.h"

namespace slipstitch {

inline constexpr char kErrorDomain[] = "slipstitch";

/// An error as clients get it: code, message and google.rpc details. The headers of gRPC are small, so violations
/// beyond about 4 KiB are left out; the ErrorInfo then says how many ("violations_left_out").
google::rpc::Status rpc_status(const jobs::Error& error);

/// SimJob.error of a failed job.
google::rpc::Status rpc_status(const jobs::Failure& failure);

}  // namespace slipstitch
