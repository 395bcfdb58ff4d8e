// SPDX-License-Identifier: MIT
#pragma once

#include "cli/options.h"

namespace slipstitch {

/// What 'frames' and 'export' print on stdout when they have written files.
void report_frames(const FrameFileOptions& options, int frames, bool json);

}  // namespace slipstitch
