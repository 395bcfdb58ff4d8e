// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "formats/formats.h"
#include "jobs/error.h"
#include "run_dir/run_dir.h"

namespace slipstitch::rest {

/// A frame of a job in an export format. NOT_FOUND, FRAME_NOT_FOUND: it has none of that index, or not yet. DATA_LOSS,
/// STORAGE_FAILED: the log is damaged in front of it.
jobs::Outcome<std::string> frame_file(const std::string& id, const RunDir& dir, std::uint32_t index,
                                      const Format& format);

}  // namespace slipstitch::rest
