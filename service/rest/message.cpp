// SPDX-License-Identifier: MIT
#include "rest/message.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace slipstitch::rest {
namespace {

// By the statuses that are sent.
std::string_view reason_phrase(unsigned status) {
  switch (status) {
    case 200:
      return "OK";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 408:
      return "Request Timeout";
    case 409:
      return "Conflict";
    case 413:
      return "Content Too Large";
    case 415:
      return "Unsupported Media Type";
    case 421:
      return "Misdirected Request";
    case 429:
      return "Too Many Requests";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Internal Server Error";
  }
}

// A value from outside must not end its header.
std::string header_value(std::string value) {
  std::replace_if(
      value.begin(), value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return value;
}

void add_header(std::string& text, const std::string& name, const std::string& value) {
  text += name + ": " + header_value(value) + "\r\n";
}

}  // namespace

const std::string* RequestHead::find(std::string_view name) const {
  const auto found =
      std::find_if(headers.begin(), headers.end(), [&](const auto& field) { return field.first == name; });
  return found == headers.end() ? nullptr : &found->second;
}

Response text_response(std::string_view content_type, std::string body) {
  Response response;
  response.headers.emplace_back("Content-Type", content_type);
  response.body = std::move(body);
  return response;
}

Response json_response(std::string body) { return text_response("application/json", std::move(body)); }

std::string head_text(const Response& response, std::optional<std::uint64_t> length, bool http_1_0, bool keep_alive) {
  std::string text = http_1_0 ? "HTTP/1.0 " : "HTTP/1.1 ";
  text += std::to_string(response.status) + " " + std::string(reason_phrase(response.status)) + "\r\n";
  bool cached = false;
  for (const auto& [name, value] : response.headers) {
    add_header(text, name, value);
    cached = cached || name == "Cache-Control";
  }
  if (!cached) add_header(text, "Cache-Control", "no-store");
  add_header(text, "X-Content-Type-Options", "nosniff");
  add_header(text, "Cross-Origin-Resource-Policy", "same-origin");
  if (length) {
    add_header(text, "Content-Length", std::to_string(*length));
  } else if (!http_1_0) {
    add_header(text, "Transfer-Encoding", "chunked");
  }
  add_header(text, "Connection", keep_alive ? "keep-alive" : "close");
  return text + "\r\n";
}

std::string chunk_text(std::string_view bytes) {
  std::array<char, 24> size{};
  std::snprintf(size.data(), size.size(), "%zx\r\n", bytes.size());
  std::string text = size.data();
  text.reserve(text.size() + bytes.size() + 2);
  text += bytes;
  return text + "\r\n";
}

}  // namespace slipstitch::rest
