// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rest/body_source.h"
#include "slipstitch/v1/job.pb.h"

namespace slipstitch::rest {

using Headers = std::vector<std::pair<std::string, std::string>>;

/// What of a request routes it. Names of headers are in lower case.
struct RequestHead {
  std::string method;  // "GET"
  std::string target;  // "/v1/simJobs?page_size=5"
  Headers headers;
  bool has_body = false;

  /// Null: none. The first of several.
  const std::string* find(std::string_view name) const;
};

/// A prediction that is part of an answer, if it can be had.
struct ToPredict {
  v1::Scene scene;
  std::function<std::string(const v1::Prediction&)> body;  // with it
};

struct Response {
  unsigned status = 200;
  Headers headers;  // besides those that every response has
  std::string body;
  std::shared_ptr<BodySource> source;   // instead of body, from after `first`
  Piece first;                          // of the source
  std::optional<std::uint64_t> length;  // of what the source gives [byte]; empty: sent in chunks
  std::optional<ToPredict> prediction;
};

Response text_response(std::string_view content_type, std::string body);
Response json_response(std::string body);

/// Status line and headers. `length`: empty for a body in chunks, or up to the end of the connection for HTTP/1.0.
std::string head_text(const Response& response, std::optional<std::uint64_t> length, bool http_1_0, bool keep_alive);

/// One chunk of chunked transfer coding; of no bytes, the last.
std::string chunk_text(std::string_view bytes);

}  // namespace slipstitch::rest
