// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "cli/remote/connection.h"

namespace slipstitch {

/// What the commands that talk to a server share. Messages go to stderr.

/// Nothing, with a message, when the address is malformed.
std::optional<Connection> connect(const std::string& server_option);

/// simJobs/{id} of a name or an id; nothing, with a message, for anything else.
std::optional<std::string> job_name(const std::string& argument);

/// Says what went wrong, with every violation and what can be done; returns the exit code.
int report_error(const RemoteError& error, const Connection& connection);

/// "slipstitch WORD NAME", with --server where the default would not reach it.
std::string command_for(const std::string& word, const std::string& name, const Connection& connection);

}  // namespace slipstitch
