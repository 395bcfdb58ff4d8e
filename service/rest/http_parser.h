// SPDX-License-Identifier: MIT
#pragma once

#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <string_view>
#include <utility>  // before asio, which needs it and does not include it

#include "rest/http_error.h"

namespace slipstitch::rest {

inline constexpr std::size_t kMaxHeaderBytes = 16 * 1024;  // of the request line and all headers

using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;

/// `max_body_bytes`: a larger body is an error of the parser.
void limit(Parser& parser, std::uint64_t max_body_bytes);

/// Gives the parser bytes of a head and tells how many it took; http::error::need_more until the head is whole.
/// Stricter than the parser: no folded lines, and no Transfer-Encoding but `chunked` alone, once, in HTTP/1.1, since
/// others tell bodies from requests in other ways (RFC 9112, 6.1).
std::size_t put_head(Parser& parser, std::string_view bytes, boost::system::error_code& error);

/// Of a parser that has the whole head.
RequestHead head_of(const Parser& parser);

/// What to answer when reading ended with `error`. Empty: nothing, there was no request or nobody is there any more.
std::optional<HttpError> read_error(const Parser& parser, const boost::system::error_code& error, int max_scene_mib);

}  // namespace slipstitch::rest
