// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace slipstitch {

/// summary.json for people, a few lines of at most 80 columns. Takes any object: what is absent or null is left out.
std::string summary_text(const nlohmann::ordered_json& summary);

}  // namespace slipstitch
