// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "run_dir/unique_fd.h"

namespace slipstitch::test {

struct HttpAnswer {
  unsigned status = 0;                         // 0: the connection ended before a whole head
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
  bool complete = false;  // the body came to its end

  std::string header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? std::string() : found->second;
  }
};

using HttpHeaders = std::vector<std::pair<std::string, std::string>>;

/// One connection to a server, blocking. What is sent may be anything; what comes is read strictly. Gives up after a
/// minute without a byte.
class HttpConnection {
 public:
  explicit HttpConnection(const std::string& address);  // 127.0.0.1:PORT

  /// False: the server has closed.
  bool send(const std::string& bytes);
  void send_request(const std::string& method, const std::string& target, const HttpHeaders& headers = {},
                    const std::string& body = "");

  /// Head and, unless `head_only`, the whole body.
  HttpAnswer read_answer(bool head_only = false);
  /// More of the body behind read_answer(true): the next part of it, empty at its end.
  std::string read_part();
  /// The body came to its proper end, as opposed to a cut connection.
  bool ended() const { return ended_; }
  /// Everything up to the end of the connection.
  std::string read_rest();
  void shutdown_sending();

 private:
  bool fill();  // false: nothing more comes
  bool read_until(const std::string& mark, std::string& text);
  std::string take(std::size_t size);
  std::string read_chunk();

  const std::string address_;
  UniqueFd socket_;
  std::string input_;
  bool chunked_ = false, ended_ = false;
  std::size_t left_ = 0;  // of a body with a length
};

/// A request on a connection of its own.
HttpAnswer http_call(const std::string& address, const std::string& method, const std::string& target,
                     const HttpHeaders& headers = {}, const std::string& body = "");

}  // namespace slipstitch::test
