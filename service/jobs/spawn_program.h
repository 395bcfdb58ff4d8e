// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace slipstitch::jobs {

/// Descriptors that a program gets as 0, 1 and 2.
struct Streams {
  int in, out, err;
};

/// Starts `command`, whose first word is the program's path, in a session of its own, so that a signal to -pid reaches
/// all of it; with NAME=VALUE of `environment`, all signals at their defaults and unblocked, and no other descriptors.
/// 0, or an errno.
int spawn_program(pid_t& pid, std::vector<std::string> command, std::vector<std::string> environment,
                  const Streams& streams);

}  // namespace slipstitch::jobs
