// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "gauntlet/gauntlet_case.h"

namespace slipstitch::gauntlet {

/// A small scene with a pattern or bare yarns, a yarn, effects, bodies and scripts drawn from the seed, and possible:
/// what is held stays out of bodies, and handles draw apart no more than yarn can follow. Passes check(); some thirty
/// steps. The same for a seed on every platform, to round-off.
GauntletCase random_case(std::uint64_t seed);

}  // namespace slipstitch::gauntlet
