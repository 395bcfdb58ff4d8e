// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "study/effect_study.h"

namespace slipstitch {

/// Two tables of at most 80 columns, what every effect changes and what it costs, and why some are not compared.
std::string effect_table(const EffectStudy& study);

}  // namespace slipstitch
