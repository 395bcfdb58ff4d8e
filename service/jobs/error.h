// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "model/issue.h"

namespace slipstitch::jobs {

/// Numbers as in google.rpc.Code.
enum class ErrorCode {
  invalid_argument = 3,
  deadline_exceeded = 4,
  not_found = 5,
  already_exists = 6,
  permission_denied = 7,
  resource_exhausted = 8,
  failed_precondition = 9,
  aborted = 10,
  unimplemented = 12,
  internal = 13,
  unavailable = 14,
  data_loss = 15,
};

/// Why a request was not done. Transports translate it, word for word.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string reason;                           // UPPER_SNAKE, at most 63 characters
  std::string message;                          // for people
  std::map<std::string, std::string> metadata;  // e.g. the limit and the flag that sets it
  Issues violations;                            // of the request's fields
  std::optional<double> retry_after_s;          // when trying again may help
};

/// A value or an error.
template <class T>
class Outcome {
 public:
  Outcome(T value) : content_(std::move(value)) {}      // NOLINT: `return value;` is the point
  Outcome(Error error) : content_(std::move(error)) {}  // NOLINT
  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  T& operator*() { return std::get<T>(content_); }
  const T& operator*() const { return std::get<T>(content_); }
  T* operator->() { return &std::get<T>(content_); }
  const T* operator->() const { return &std::get<T>(content_); }
  const Error& error() const { return std::get<Error>(content_); }

 private:
  std::variant<T, Error> content_;
};

struct Done {};

/// Problems of a scene or of request fields. RESOURCE_EXHAUSTED when nothing but limits is hurt, with the first limit.
Error error_from_issues(Issues issues);

Error invalid_field(const std::string& field, const std::string& value, const std::string& expected);
Error job_not_found(const std::string& id);
Error wrong_state(const std::string& id, const std::string& reason, const std::string& message);
Error no_frames(const std::string& id);
Error server_stopping();
Error storage_failed(const std::string& message);

}  // namespace slipstitch::jobs
