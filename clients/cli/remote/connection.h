// SPDX-License-Identifier: MIT
#pragma once

#include <grpcpp/client_context.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "cli/remote/remote_error.h"
#include "slipstitch/v1/frames.grpc.pb.h"
#include "slipstitch/v1/job.grpc.pb.h"

namespace slipstitch {

inline constexpr std::chrono::seconds kCallTimeout{30};

/// A server's stubs. Nothing is connected before the first call.
class Connection {
 public:
  explicit Connection(std::string address);

  const std::string& address() const { return address_; }
  v1::SimJobs::Stub& jobs() const { return *jobs_; }
  v1::Frames::Stub& frames() const { return *frames_; }

 private:
  std::string address_;
  std::unique_ptr<v1::SimJobs::Stub> jobs_;
  std::unique_ptr<v1::Frames::Stub> frames_;
};

/// One call of a method without streams, e.g. unary<v1::SimJob>(jobs, &v1::SimJobs::Stub::GetSimJob, request).
template <class Response, class Stub, class Request>
Reply<Response> unary(Stub& stub, grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                      const Request& request) {
  grpc::ClientContext context;
  context.set_deadline(std::chrono::system_clock::now() + kCallTimeout);
  Response response;
  const grpc::Status status = (stub.*method)(&context, request, &response);
  if (!status.ok()) return {std::nullopt, remote_error(status)};
  return {std::move(response), {}};
}

}  // namespace slipstitch
