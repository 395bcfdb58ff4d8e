// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch {

inline constexpr char kDefaultServer[] = "127.0.0.1:50651";

/// `given` unless empty, else SLIPSTITCH_SERVER unless empty, else the default.
std::string server_address(const std::string& given);

/// HOST:PORT, [IPV6]:PORT or unix:PATH, with a port from 1 to 65535.
bool valid_address(const std::string& address);

/// This machine itself: proxies have no business there.
bool is_loopback(const std::string& address);

}  // namespace slipstitch
