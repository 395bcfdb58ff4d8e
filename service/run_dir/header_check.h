// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sim/frame.h"

namespace slipstitch {

/// Empty when every count, index, enum and number of a header that came from outside can be trusted; else the first
/// flaw.
std::string header_flaw(const FrameHeader& header);

}  // namespace slipstitch
