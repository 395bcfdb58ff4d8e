// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "model/issue.h"
#include "scene_io/json_tree.h"

namespace slipstitch {

/// Applies "a.b[2].c=VALUE" to the document. Missing objects and arrays are made; an index may be at most the array's
/// length (which appends). VALUE is JSON, or else a string. A path that cannot be followed is an
/// issue of the document as a whole.
void apply_setting(JsonNode& root, const std::string& setting, Issues& issues);

}  // namespace slipstitch
