// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>

#include "math/types.h"

namespace slipstitch {

/// Calls visit(i, j), i < j, for every two of the boxes that overlap, in no particular order.
void for_each_overlap(std::span<const Eigen::AlignedBox3d> boxes, const std::function<void(int, int)>& visit);

}  // namespace slipstitch
