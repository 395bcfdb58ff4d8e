// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/screen/text.h"

namespace slipstitch {

/// summary.json for people, a few lines of at most 80 columns. Takes any object: what is absent or null is left out.
/// `more` comes below.
std::string summary_text(const nlohmann::ordered_json& summary, const Rows& more = {});

}  // namespace slipstitch
