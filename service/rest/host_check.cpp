// SPDX-License-Identifier: MIT
#include "rest/host_check.h"

#include <algorithm>

#include "rest/ascii.h"

namespace slipstitch::rest {
namespace {

bool is_number(std::string_view text, std::size_t longest) {
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// 127.a.b.c; not "127.0.0.1.example.com".
bool is_loopback_ipv4(std::string_view host) {
  int parts = 0;
  for (std::size_t begin = 0; begin <= host.size(); ++parts) {
    const std::size_t dot = std::min(host.find('.', begin), host.size());
    const std::string_view part = host.substr(begin, dot - begin);
    if (!is_number(part, 3) || (parts == 0 && part != "127")) return false;
    begin = dot + 1;
  }
  return parts == 4;
}

bool is_served(const std::string& host, const ServedHosts& hosts) {
  if (host.empty()) return false;
  return host == "localhost" || host == "::1" || is_loopback_ipv4(host) || host == lower_case(hosts.bound) ||
         host == lower_case(hosts.local);
}

}  // namespace

std::string host_of(std::string_view authority) {
  std::string_view host = authority, port;
  if (authority.starts_with('[')) {
    const std::size_t end = authority.find(']');
    if (end == std::string_view::npos) return {};
    host = authority.substr(1, end - 1);
    port = authority.substr(end + 1);
  } else if (const std::size_t colon = authority.find(':'); colon != std::string_view::npos) {
    host = authority.substr(0, colon);
    port = authority.substr(colon);
  }
  if (!port.empty() && (port[0] != ':' || !is_number(port.substr(1), 5))) return {};
  return lower_case(host);
}

std::optional<HttpError> check_host_and_origin(const RequestHead& request, const ServedHosts& hosts) {
  const auto named_host = [](const auto& field) { return field.first == "host"; };
  if (std::count_if(request.headers.begin(), request.headers.end(), named_host) != 1) {
    return malformed_request("it needs exactly one Host");
  }
  const std::string& host = *request.find("host");
  if (!is_served(host_of(host), hosts)) return wrong_host(host);
  for (const auto& [name, value] : request.headers) {
    if (name == "origin" && lower_case(value) != "http://" + lower_case(host)) return wrong_origin(value);
  }
  return std::nullopt;
}

}  // namespace slipstitch::rest
