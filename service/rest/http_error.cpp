// SPDX-License-Identifier: MIT
#include "rest/http_error.h"

#include <cmath>

#include "api/rpc_status.h"
#include "rest/api_json.h"

namespace slipstitch::rest {
namespace {

constexpr std::size_t kShown = 200;  // of what a client sent [byte]
constexpr double kRetryConnection_s = 1.0;

// Bytes that are no printable ASCII are replaced, so that whatever came in is UTF-8 and harmless in a terminal.
std::string shown(const std::string& text) {
  std::string result = text.substr(0, kShown);
  for (char& c : result) {
    if (c < 0x20 || c == 0x7f) c = '?';
  }
  return result;
}

jobs::Error limit_error(jobs::ErrorCode code, const std::string& reason, const std::string& message,
                        const std::string& limit, const std::string& flag) {
  jobs::Error error{code, reason, message, {{"limit", limit}}, {}, {}};
  if (!flag.empty()) error.metadata["flag"] = flag;
  return error;
}

// Without zeros at its end.
std::string decimal(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

unsigned http_status(const jobs::Error& error) {
  switch (error.code) {
    case jobs::ErrorCode::invalid_argument:
      return 400;
    case jobs::ErrorCode::permission_denied:
      return 403;
    case jobs::ErrorCode::not_found:
      return 404;
    case jobs::ErrorCode::unimplemented:
      return 405;
    case jobs::ErrorCode::deadline_exceeded:
      return 408;
    case jobs::ErrorCode::already_exists:
    case jobs::ErrorCode::failed_precondition:
    case jobs::ErrorCode::aborted:
      return 409;
    case jobs::ErrorCode::resource_exhausted:
      return error.retry_after_s ? 429 : 413;
    case jobs::ErrorCode::unavailable:
      return 503;
    case jobs::ErrorCode::data_loss:
    case jobs::ErrorCode::internal:
      break;
  }
  return 500;
}

HttpError http_error(jobs::Error error) {
  const unsigned status = http_status(error);
  return {status, std::move(error)};
}

Response error_response(const HttpError& error) {
  Response response = json_response(api_json(rpc_status(error.error)) + "\n");
  response.status = error.status;
  response.headers.insert(response.headers.end(), error.headers.begin(), error.headers.end());
  if (error.error.retry_after_s) {
    response.headers.emplace_back("Retry-After", std::to_string(std::lround(std::ceil(*error.error.retry_after_s))));
  }
  return response;
}

Response error_response(const jobs::Error& error) { return error_response(http_error(error)); }

HttpError malformed_request(const std::string& why) {
  return {400, {jobs::ErrorCode::invalid_argument, "MALFORMED_REQUEST", "the request is not HTTP: " + why, {}, {}, {}}};
}

HttpError wrong_parameter(const std::string& name, const std::string& value, const std::string& expected) {
  return http_error(jobs::invalid_field(shown(name), shown(value), expected));
}

HttpError no_such_path(const std::string& path) {
  return http_error({jobs::ErrorCode::not_found,
                     "NO_SUCH_PATH",
                     "there is nothing at " + shown(path) + "; /openapi.json lists all there is",
                     {},
                     {},
                     {}});
}

HttpError method_not_allowed(const std::string& method, const std::string& allowed) {
  HttpError error = http_error({jobs::ErrorCode::unimplemented,
                                "METHOD_NOT_ALLOWED",
                                "this path does not take " + shown(method) + ", only " + allowed,
                                {{"allowed", allowed}},
                                {},
                                {}});
  error.headers.emplace_back("Allow", allowed);
  return error;
}

HttpError unsupported_media_type(const std::string& type) {
  const std::string given = type.empty() ? "none" : "'" + shown(type) + "'";
  return {415,
          {jobs::ErrorCode::invalid_argument,
           "UNSUPPORTED_MEDIA_TYPE",
           "the Content-Type is " + given + ", expected application/json",
           {},
           {},
           {}}};
}

HttpError unsupported_encoding(const std::string& encoding) {
  return {415,
          {jobs::ErrorCode::invalid_argument,
           "UNSUPPORTED_MEDIA_TYPE",
           "the Content-Encoding is '" + shown(encoding) + "', expected none",
           {},
           {},
           {}}};
}

HttpError wrong_host(const std::string& host) {
  return {421,
          {jobs::ErrorCode::permission_denied,
           "WRONG_HOST",
           "this server does not answer for the host '" + shown(host) +
               "', only for loopback names and the address it listens on (--http)",
           {},
           {},
           {}}};
}

HttpError wrong_origin(const std::string& origin) {
  return {403,
          {jobs::ErrorCode::permission_denied,
           "WRONG_ORIGIN",
           "pages of '" + shown(origin) + "' may not use this server, only its own",
           {},
           {},
           {}}};
}

HttpError headers_too_big(std::size_t limit) {
  return {431, limit_error(jobs::ErrorCode::resource_exhausted, "HEADERS_TOO_BIG",
                           "request line and headers are longer than " + std::to_string(limit) + " bytes",
                           std::to_string(limit), "")};
}

HttpError request_timeout(double limit_s) {
  const std::string limit = decimal(limit_s);
  return {408,
          limit_error(jobs::ErrorCode::deadline_exceeded, "REQUEST_TIMEOUT",
                      "the request was not complete within " + limit + " s (--http-timeout)", limit, "--http-timeout")};
}

HttpError too_many_connections(int limit) {
  jobs::Error error = limit_error(jobs::ErrorCode::unavailable, "TOO_MANY_CONNECTIONS",
                                  "there are " + std::to_string(limit) + " connections already (--http-connections)",
                                  std::to_string(limit), "--http-connections");
  error.retry_after_s = kRetryConnection_s;
  return {503, error};
}

HttpError too_many_uploads(int limit) {
  jobs::Error error = limit_error(jobs::ErrorCode::unavailable, "TOO_MANY_UPLOADS",
                                  std::to_string(limit) + " large requests are being sent already; try again",
                                  std::to_string(limit), "");
  error.retry_after_s = kRetryConnection_s;
  return {503, error};
}

HttpError too_many_exports(std::size_t limit_bytes, double waited_s) {
  const std::string limit = std::to_string(limit_bytes);
  jobs::Error error =
      limit_error(jobs::ErrorCode::unavailable, "TOO_MANY_EXPORTS",
                  "other clients' frames are being made, or sent and hold up to " + limit +
                      " bytes; no turn came within " + decimal(waited_s) + " s (--http-timeout); try again",
                  limit, "");
  error.retry_after_s = kRetryConnection_s;
  return {503, error};
}

}  // namespace slipstitch::rest
