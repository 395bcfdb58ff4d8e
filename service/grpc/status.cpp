// SPDX-License-Identifier: MIT
#include "grpc/status.h"

#include <cmath>

#include "google/rpc/error_details.pb.h"
#include "scene_io/issue_text.h"

namespace slipstitch {
namespace {

constexpr std::size_t kMaxText = 512;             // of one message, path or description [byte]
constexpr std::size_t kMaxViolationBytes = 4096;  // of all violations

// Cut at a character, because protobuf refuses broken UTF-8.
std::string shortened(const std::string& text) {
  if (text.size() <= kMaxText) return text;
  std::size_t end = kMaxText;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

grpc::StatusCode code_of(jobs::ErrorCode code) {
  switch (code) {
    case jobs::ErrorCode::invalid_argument:
      return grpc::StatusCode::INVALID_ARGUMENT;
    case jobs::ErrorCode::not_found:
      return grpc::StatusCode::NOT_FOUND;
    case jobs::ErrorCode::already_exists:
      return grpc::StatusCode::ALREADY_EXISTS;
    case jobs::ErrorCode::failed_precondition:
      return grpc::StatusCode::FAILED_PRECONDITION;
    case jobs::ErrorCode::resource_exhausted:
      return grpc::StatusCode::RESOURCE_EXHAUSTED;
    case jobs::ErrorCode::unavailable:
      return grpc::StatusCode::UNAVAILABLE;
    case jobs::ErrorCode::aborted:
      return grpc::StatusCode::ABORTED;
    case jobs::ErrorCode::data_loss:
      return grpc::StatusCode::DATA_LOSS;
    case jobs::ErrorCode::internal:
      break;
  }
  return grpc::StatusCode::INTERNAL;
}

// Returns how many did not fit.
std::size_t add_violations(const Issues& issues, google::rpc::BadRequest& bad_request) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < issues.size(); ++i) {
    const std::string field = shortened(issues[i].path), description = shortened(describe(issues[i]));
    bytes += field.size() + description.size() + 8;
    if (bytes > kMaxViolationBytes && i > 0) return issues.size() - i;
    auto* violation = bad_request.add_field_violations();
    violation->set_field(field);
    violation->set_description(description);
  }
  return 0;
}

google::rpc::ErrorInfo error_info(const std::string& reason) {
  google::rpc::ErrorInfo info;
  info.set_reason(reason);
  info.set_domain(kErrorDomain);
  return info;
}

void add_retry(double seconds, google::rpc::Status& status) {
  google::rpc::RetryInfo retry;
  retry.mutable_retry_delay()->set_seconds(static_cast<std::int64_t>(seconds));
  retry.mutable_retry_delay()->set_nanos(static_cast<std::int32_t>((seconds - std::floor(seconds)) * 1e9));
  status.add_details()->PackFrom(retry);
}

}  // namespace

google::rpc::Status rpc_status(const jobs::Error& error) {
  google::rpc::Status status;
  status.set_code(code_of(error.code));
  status.set_message(shortened(error.message));
  google::rpc::ErrorInfo info = error_info(error.reason);
  for (const auto& [key, value] : error.metadata) (*info.mutable_metadata())[key] = shortened(value);
  google::rpc::BadRequest bad_request;
  const std::size_t left_out = add_violations(error.violations, bad_request);
  if (left_out > 0) (*info.mutable_metadata())["violations_left_out"] = std::to_string(left_out);
  status.add_details()->PackFrom(info);
  if (bad_request.field_violations_size() > 0) status.add_details()->PackFrom(bad_request);
  if (error.retry_after_s) add_retry(*error.retry_after_s, status);
  return status;
}

grpc::Status grpc_status(const jobs::Error& error) {
  const google::rpc::Status status = rpc_status(error);
  return {static_cast<grpc::StatusCode>(status.code()), status.message(), status.SerializeAsString()};
}

google::rpc::Status rpc_status(const jobs::Failure& failure) {
  google::rpc::Status status;
  status.set_code(grpc::StatusCode::INTERNAL);
  std::string tail;
  for (const std::string& line : failure.log_tail) tail += "\n" + line;
  status.set_message(failure.message + (tail.empty() ? "" : "; its log ended:" + tail));
  google::rpc::ErrorInfo info = error_info(failure.reason);
  if (!tail.empty()) (*info.mutable_metadata())["log_tail"] = tail.substr(1);
  status.add_details()->PackFrom(info);
  return status;
}

}  // namespace slipstitch
