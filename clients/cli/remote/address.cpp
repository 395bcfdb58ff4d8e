// SPDX-License-Identifier: MIT
#include "cli/remote/address.h"

#include <charconv>
#include <cstdlib>

namespace slipstitch {
namespace {

constexpr char kUnix[] = "unix:";

std::string host_of(const std::string& address) { return address.substr(0, address.rfind(':')); }

bool valid_port(const std::string& text) {
  int port = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), port);
  return parsed.ec == std::errc() && parsed.ptr == text.data() + text.size() && port >= 1 && port <= 65535;
}

}  // namespace

std::string server_address(const std::string& given) {
  if (!given.empty()) return given;
  const char* variable = std::getenv("SLIPSTITCH_SERVER");
  return variable != nullptr && *variable != '\0' ? variable : kDefaultServer;
}

bool valid_address(const std::string& address) {
  if (address.starts_with(kUnix)) return address.size() > sizeof(kUnix) - 1;
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos || colon == 0 || !valid_port(address.substr(colon + 1))) return false;
  const std::string host = host_of(address);
  const bool bracketed = host.front() == '[' && host.back() == ']' && host.size() > 2;
  return bracketed || host.find_first_of(":/ []@") == std::string::npos;
}

bool is_loopback(const std::string& address) {
  const std::string host = host_of(address);
  return address.starts_with(kUnix) || host == "localhost" || host == "[::1]" || host.starts_with("127.");
}

}  // namespace slipstitch
