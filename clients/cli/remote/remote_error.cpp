// SPDX-License-Identifier: MIT
#include "cli/remote/remote_error.h"

#include "google/rpc/error_details.pb.h"

namespace slipstitch {
namespace {

void add_detail(const google::protobuf::Any& detail, RemoteError& error) {
  google::rpc::ErrorInfo info;
  google::rpc::BadRequest bad_request;
  google::rpc::RetryInfo retry;
  if (detail.UnpackTo(&info)) {
    error.reason = info.reason();
    error.metadata = {info.metadata().begin(), info.metadata().end()};
  } else if (detail.UnpackTo(&bad_request)) {
    for (const auto& violation : bad_request.field_violations()) {
      error.violations.emplace_back(violation.field(), violation.description());
    }
  } else if (detail.UnpackTo(&retry)) {
    error.retry_after_s =
        static_cast<double>(retry.retry_delay().seconds()) + 1e-9 * static_cast<double>(retry.retry_delay().nanos());
  }
}

}  // namespace

RemoteError remote_error(const google::rpc::Status& status) {
  RemoteError error;
  error.code = static_cast<grpc::StatusCode>(status.code());
  error.message = status.message();
  for (const google::protobuf::Any& detail : status.details()) add_detail(detail, error);
  return error;
}

RemoteError remote_error(const grpc::Status& status) {
  google::rpc::Status rich;
  if (!status.error_details().empty() && rich.ParseFromString(status.error_details())) {
    RemoteError error = remote_error(rich);
    error.code = status.error_code();
    return error;
  }
  RemoteError error;
  error.code = status.error_code();
  error.message = status.error_message();
  if (error.code == grpc::StatusCode::CANCELLED) {  // nobody here asked for it: a server that shuts down ends calls so
    error.code = grpc::StatusCode::UNAVAILABLE;
    error.message = "the server ended the call";
  }
  return error;
}

std::string plain_text(const RemoteError& error) {
  if (!error.reason.empty() || error.code != grpc::StatusCode::UNAVAILABLE) return error.message;
  const std::size_t colon = error.message.rfind(": ");
  return colon == std::string::npos ? error.message : error.message.substr(colon + 2);
}

bool worth_a_retry(const RemoteError& error) {
  return error.code == grpc::StatusCode::UNAVAILABLE || error.reason == "STREAM_STALLED";
}

}  // namespace slipstitch
