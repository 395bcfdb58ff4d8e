// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "run_dir/result.h"
#include "sim/frame.h"

namespace slipstitch {

/// FrameHeader as bytes: fields in the order of their declaration, integers as i32, enums and flags as u8, doubles as
/// f64, arrays as u64 count + elements; little endian. A changed struct needs a new kRecordVersion.
std::string encode_header(const FrameHeader& header);

/// Refuses counts beyond the bytes given, unknown enum values, non-finite numbers and any index out of range, so that
/// what comes back can be used without further checks.
Result<FrameHeader> decode_header(std::string_view bytes);

}  // namespace slipstitch
