// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace slipstitch {

inline constexpr int kMaxPushes = 100;  // of all contacts in turn
// In deepest overlaps: what a push leaves, what it leaves where there was as much, what is worth it.
inline constexpr double kPushedOverlap = 0.5, kDeepestLeft = 0.9, kLeastPush = 1e-3;

/// How far a contact has to give way whose gap scripts have changed from `before` to `gap`, w its deepest overlap [m].
/// No farther than it was, but for the last tenth: yarn that a load presses deep would, as a lever, sweep far for
/// nothing. None where scripts have changed nothing: yarn that forces pinch would be pushed out of one body into another.
inline double push_needed(double w, double gap, double before) {
  if (gap >= before && gap > -w) return 0.0;
  const double push = std::min(-kPushedOverlap * w, std::max(before, -kDeepestLeft * w)) - gap;
  return push > kLeastPush * w ? push : 0.0;
}

}  // namespace slipstitch
