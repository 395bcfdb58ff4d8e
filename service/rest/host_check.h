// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "rest/http_error.h"

namespace slipstitch::rest {

/// Hosts that are ours besides the loopback's names and addresses. Without this check a page of any site could reach
/// the server under a name of its own that resolves to our address (DNS rebinding).
struct ServedHosts {
  std::string bound;  // as in --http, without the port; "[::1]" as "::1"
  std::string local;  // address of this end of the connection
};

/// HOST of "HOST:PORT" in lower case and without the brackets of an IPv6 address. Empty: malformed.
std::string host_of(std::string_view authority);

/// Host must be one of ours; Origin, where there is one, that of our own pages.
std::optional<HttpError> check_host_and_origin(const RequestHead& request, const ServedHosts& hosts);

}  // namespace slipstitch::rest
