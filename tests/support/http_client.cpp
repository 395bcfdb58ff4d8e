// SPDX-License-Identifier: MIT
#include "support/http_client.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <algorithm>
#include <array>

namespace slipstitch::test {
namespace {

constexpr int kPatience_s = 60;  // only guards against a hang

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

// "Name: value" lines behind the status line.
void parse_head(const std::string& head, HttpAnswer& answer) {
  EXPECT_TRUE(head.starts_with("HTTP/1.")) << head;
  answer.status = static_cast<unsigned>(std::stoul(head.substr(9, 3)));
  for (std::size_t line = std::min(head.find("\r\n"), head.size() - 2) + 2; line < head.size();) {
    const std::size_t end = std::min(head.find("\r\n", line), head.size()), colon = head.find(": ", line);
    if (colon >= end) {
      ADD_FAILURE() << "no header: " << head.substr(line, end - line);
      return;
    }
    answer.headers[lower_case(head.substr(line, colon - line))] = head.substr(colon + 2, end - colon - 2);
    line = end + 2;
  }
}

}  // namespace

HttpConnection::HttpConnection(const std::string& address)
    : address_(address), socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
  EXPECT_EQ(::connect(socket_.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0) << address;
  const timeval patience{kPatience_s, 0};
  ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  const int on = 1;
  ::setsockopt(socket_.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

bool HttpConnection::send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t size = ::send(socket_.get(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (size <= 0) return false;
    sent += static_cast<std::size_t>(size);
  }
  return true;
}

void HttpConnection::send_request(const std::string& method, const std::string& target, const HttpHeaders& headers,
                                  const std::string& body) {
  std::string text = method + " " + target + " HTTP/1.1\r\n";
  const auto named = [&](const char* name) {
    return std::any_of(headers.begin(), headers.end(), [&](const auto& h) { return lower_case(h.first) == name; });
  };
  if (!named("host")) text += "Host: " + address_ + "\r\n";
  for (const auto& [name, value] : headers) text += name + ": " + value + "\r\n";
  if (!body.empty() && !named("content-length")) text += "Content-Length: " + std::to_string(body.size()) + "\r\n";
  send(text + "\r\n" + body);
}

bool HttpConnection::fill() {
  std::array<char, 65536> bytes{};
  const ssize_t size = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
  EXPECT_FALSE(size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) << "the server says nothing";
  if (size <= 0) return false;
  input_.append(bytes.data(), static_cast<std::size_t>(size));
  return true;
}

bool HttpConnection::read_until(const std::string& mark, std::string& text) {
  std::size_t end = input_.find(mark);
  for (; end == std::string::npos; end = input_.find(mark)) {
    if (!fill()) return false;
  }
  text = take(end);
  take(mark.size());
  return true;
}

std::string HttpConnection::take(std::size_t size) {
  std::string text = input_.substr(0, size);
  input_.erase(0, size);
  return text;
}

HttpAnswer HttpConnection::read_answer(bool head_only) {
  HttpAnswer answer;
  std::string head;
  do {
    if (!read_until("\r\n\r\n", head)) return answer;
    parse_head(head, answer);
  } while (answer.status == 100);
  chunked_ = answer.header("transfer-encoding") == "chunked";
  left_ = answer.headers.contains("content-length") ? std::stoull(answer.header("content-length")) : 0;
  ended_ = !chunked_ && left_ == 0;
  if (head_only) return answer;
  for (std::string part = read_part(); !part.empty(); part = read_part()) answer.body += part;
  answer.complete = ended_;
  return answer;
}

std::string HttpConnection::read_part() {
  if (ended_) return {};
  if (chunked_) return read_chunk();
  if (input_.empty() && !fill()) return {};
  std::string part = take(std::min(left_, input_.size()));
  left_ -= part.size();
  ended_ = left_ == 0;
  return part;
}

std::string HttpConnection::read_chunk() {
  std::string size_line;
  if (!read_until("\r\n", size_line)) return {};
  const std::size_t size = std::stoull(size_line, nullptr, 16);
  while (input_.size() < size + 2) {
    if (!fill()) return {};
  }
  std::string part = take(size);
  EXPECT_EQ(take(2), "\r\n");
  ended_ = size == 0;
  return part;
}

std::string HttpConnection::read_rest() {
  while (fill()) {
  }
  return std::move(input_);
}

void HttpConnection::shutdown_sending() { ::shutdown(socket_.get(), SHUT_WR); }

HttpAnswer http_call(const std::string& address, const std::string& method, const std::string& target,
                     const HttpHeaders& headers, const std::string& body) {
  HttpConnection connection(address);
  connection.send_request(method, target, headers, body);
  return connection.read_answer(method == "HEAD");
}

}  // namespace slipstitch::test
