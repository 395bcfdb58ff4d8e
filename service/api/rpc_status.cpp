// SPDX-License-Identifier: MIT
#include "api/rpc_status.h"

#include <cmath>

#include "google/rpc/error_details.pb.h"
#include "scene_io/issue_text.h"
#include "scene_io/json_tree.h"

namespace slipstitch {
namespace {

constexpr std::size_t kMaxText = 512;             // of one message, path or description [byte]
constexpr std::size_t kMaxViolationBytes = 4096;  // of all violations

// Protobuf refuses what is not UTF-8.
std::string presentable(const std::string& text) { return shortened(valid_utf8(text), kMaxText); }

// Returns how many did not fit.
std::size_t add_violations(const Issues& issues, google::rpc::BadRequest& bad_request) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < issues.size(); ++i) {
    const std::string field = presentable(issues[i].path), description = presentable(describe(issues[i]));
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
  status.set_code(static_cast<int>(error.code));
  status.set_message(presentable(error.message));
  google::rpc::ErrorInfo info = error_info(error.reason);
  for (const auto& [key, value] : error.metadata) (*info.mutable_metadata())[key] = presentable(value);
  google::rpc::BadRequest bad_request;
  const std::size_t left_out = add_violations(error.violations, bad_request);
  if (left_out > 0) (*info.mutable_metadata())["violations_left_out"] = std::to_string(left_out);
  status.add_details()->PackFrom(info);
  if (bad_request.field_violations_size() > 0) status.add_details()->PackFrom(bad_request);
  if (error.retry_after_s) add_retry(*error.retry_after_s, status);
  return status;
}

google::rpc::Status rpc_status(const jobs::Failure& failure) {
  google::rpc::Status status;
  status.set_code(static_cast<int>(jobs::ErrorCode::internal));
  std::string tail;
  for (const std::string& line : failure.log_tail) tail += "\n" + line;
  status.set_message(failure.message + (tail.empty() ? "" : "; its log ended:" + tail));
  google::rpc::ErrorInfo info = error_info(failure.reason);
  if (!tail.empty()) (*info.mutable_metadata())["log_tail"] = tail.substr(1);
  status.add_details()->PackFrom(info);
  return status;
}

}  // namespace slipstitch
