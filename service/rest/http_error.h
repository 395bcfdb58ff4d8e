// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "jobs/error.h"
#include "rest/message.h"

namespace slipstitch::rest {

/// An error with its HTTP status. That of errors of jobs follows from their code; what HTTP itself is refused for has
/// one of its own.
struct HttpError {
  unsigned status = 500;
  jobs::Error error;
  Headers headers = {};  // besides those of every error, e.g. Allow
};

/// INVALID_ARGUMENT 400, PERMISSION_DENIED 403, NOT_FOUND 404, UNIMPLEMENTED 405, DEADLINE_EXCEEDED 408,
/// ALREADY_EXISTS, FAILED_PRECONDITION and ABORTED 409, RESOURCE_EXHAUSTED 429 where trying again may help and 413
/// where not, UNAVAILABLE 503, else 500.
unsigned http_status(const jobs::Error& error);
HttpError http_error(jobs::Error error);

/// google.rpc.Status as JSON, and Retry-After where trying again may help.
Response error_response(const HttpError& error);
Response error_response(const jobs::Error& error);

HttpError malformed_request(const std::string& why);
HttpError wrong_parameter(const std::string& name, const std::string& value, const std::string& expected);
HttpError no_such_path(const std::string& path);
HttpError method_not_allowed(const std::string& method, const std::string& allowed);
HttpError unsupported_media_type(const std::string& type);
HttpError unsupported_encoding(const std::string& encoding);
HttpError wrong_host(const std::string& host);
HttpError wrong_origin(const std::string& origin);
HttpError headers_too_big(std::size_t limit);
HttpError request_timeout(double limit_s);
HttpError too_many_connections(int limit);
HttpError too_many_uploads(int limit);
HttpError too_many_exports(std::size_t limit_bytes, double waited_s);

}  // namespace slipstitch::rest
