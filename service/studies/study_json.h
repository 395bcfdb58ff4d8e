// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "study/work_precision.h"

namespace slipstitch {

/// A study in short, with the names of its files. What is not known is null.
nlohmann::ordered_json study_json(const WorkPrecision& study);

}  // namespace slipstitch
