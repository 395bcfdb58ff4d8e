// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "run_dir/result.h"

namespace slipstitch {

/// Replaces `path` as a whole: temporary file beside it, fsync, rename, fsync of the folder. A reader, or whoever comes
/// after a crash, finds the old content or the new one, never a mixture.
IoError write_file_atomic(const std::filesystem::path& path, std::string_view bytes);

/// Whole content; fails above `max_bytes`, before reading.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Makes created, renamed and removed entries of a folder survive a power loss.
IoError sync_folder(const std::filesystem::path& folder);

}  // namespace slipstitch
