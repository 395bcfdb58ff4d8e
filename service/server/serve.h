// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace slipstitch {

/// slipstitchd, and `slipstitch serve` (`program` is how the user called it): serves until SIGTERM or SIGINT. Prints
/// "slipstitchd ready grpc=ADDR http=ADDR" on stdout when ready, all else on stderr. Returns the exit code: 0 stopped,
/// 1 cannot serve (data directory in use, address taken), 2 bad usage. Call it before any thread is started, because
/// it blocks SIGTERM and SIGINT.
int serve(const std::vector<std::string>& arguments, const std::string& program);

}  // namespace slipstitch
