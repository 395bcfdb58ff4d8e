// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/interrupt.h"
#include "cli/remote/connection.h"

namespace slipstitch {

/// Shows a job's progress until it ends, prints its summary and returns its exit code. Ctrl-C leaves the job running.
/// Make the interrupt before the connection.
int follow_job(const Connection& connection, const std::string& name, Interrupt& interrupt, bool json);

}  // namespace slipstitch
