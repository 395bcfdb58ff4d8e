// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "study/calibration.h"

namespace slipstitch {

/// $XDG_CACHE_HOME/slipstitch, ~/.cache/slipstitch, or empty where neither variable says.
std::filesystem::path default_cache_folder();

/// What a calibration holds for: version of the program, BLAS core, CPU.
std::string calibration_key();

std::string calibration_json(const Calibration& calibration, const std::string& key);
/// Nothing: not such a text, of another key, or not sound.
std::optional<Calibration> calibration_from_json(std::string_view text, const std::string& key);

/// The calibration kept in `folder` for `key`, else a new one, which is kept there if that can be: whatever is wrong
/// with the folder or the file, there is a calibration. Empty folder: none is kept.
Calibration kept_calibration(const std::filesystem::path& folder, const std::string& key,
                             const std::function<Calibration()>& calibrate);

/// Of this machine, from the user's cache; made at the first call of a process. Threads may call it at once.
const Calibration& machine_calibration();

}  // namespace slipstitch
