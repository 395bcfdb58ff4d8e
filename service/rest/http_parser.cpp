// SPDX-License-Identifier: MIT
#include "rest/http_parser.h"

#include <boost/beast/http/error.hpp>
#include <iterator>

#include "api/create_job.h"
#include "rest/ascii.h"

namespace slipstitch::rest {
namespace http = boost::beast::http;

namespace {

// `bytes` begin at the start of a line, or within the first.
bool has_folded_line(std::string_view bytes) {
  for (std::size_t line = 0;;) {
    const std::size_t end = bytes.find("\r\n", line);
    if (end == line || end == std::string_view::npos || end + 2 == bytes.size()) return false;
    line = end + 2;
    if (bytes[line] == ' ' || bytes[line] == '\t') return true;
  }
}

// Whether where the body ends can be read in one way only.
bool has_clear_end(const Parser& parser) {
  const auto& request = parser.get();
  const auto codings = request.equal_range(http::field::transfer_encoding);
  if (codings.first == codings.second) return true;
  const bool alone = std::next(codings.first) == codings.second && request.count(http::field::content_length) == 0;
  return alone && request.version() == 11 && lower_case(std::string(codings.first->value())) == "chunked";
}

}  // namespace

void limit(Parser& parser, std::uint64_t max_body_bytes) {
  parser.header_limit(static_cast<std::uint32_t>(kMaxHeaderBytes));
  parser.body_limit(max_body_bytes);
}

std::size_t put_head(Parser& parser, std::string_view bytes, boost::system::error_code& error) {
  if (has_folded_line(bytes)) {
    error = http::error::bad_obs_fold;
    return 0;
  }
  const std::size_t taken = parser.put(boost::asio::const_buffer(bytes.data(), bytes.size()), error);
  if (!error && parser.is_header_done() && !has_clear_end(parser)) error = http::error::bad_transfer_encoding;
  return taken;
}

RequestHead head_of(const Parser& parser) {
  RequestHead head;
  const auto& request = parser.get();
  head.method = std::string(request.method_string());
  head.target = std::string(request.target());
  for (const auto& field : request) {
    head.headers.emplace_back(lower_case(std::string(field.name_string())), std::string(field.value()));
  }
  head.has_body = parser.chunked() || parser.content_length().value_or(0) > 0;
  return head;
}

std::optional<HttpError> read_error(const Parser& parser, const boost::system::error_code& error, int max_scene_mib) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return headers_too_big(kMaxHeaderBytes);
  }
  if (error == http::error::body_limit) {
    const std::string method(parser.get().method_string());
    if (method != "POST") return malformed_request(method + " has no body");
    return http_error(request_too_big(std::nullopt, max_scene_mib));
  }
  const bool gone = error == http::error::end_of_stream || error == http::error::partial_message;
  if (gone || error.category() != http::make_error_code(http::error::bad_method).category()) return std::nullopt;
  if (error == http::error::bad_obs_fold) return malformed_request("a header goes on in a second line");
  if (error == http::error::bad_transfer_encoding) {
    return malformed_request("Transfer-Encoding is not \"chunked\" alone, in HTTP/1.1 and without Content-Length");
  }
  return malformed_request(error.message());
}

}  // namespace slipstitch::rest
