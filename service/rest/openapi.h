// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace slipstitch::rest {

/// OpenAPI 3.0 of all operations, generated from their table and the schema's descriptors.
std::string openapi_document();

}  // namespace slipstitch::rest
