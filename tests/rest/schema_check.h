// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace slipstitch::test {

/// What of a value breaks a schema of an OpenAPI document, by the keywords that ours uses; an unknown one is told too.
/// Empty: nothing.
std::string schema_flaw(const nlohmann::json& value, const nlohmann::json& schema, const nlohmann::json& document);

}  // namespace slipstitch::test
