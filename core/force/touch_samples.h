// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "model/model.h"

namespace slipstitch {

/// A point of a yarn's centreline where it can touch something: x = (1 - share) x0 + share x1 on segment `visit`.
struct TouchSample {
  int visit = 0;
  double share = 0.0;           // in [0, 1]
  std::array<int, 6> coords{};  // x0, x1
};

enum class TouchPoints { free, all };  // free: without those that handles move, which go where the script says

/// Every node once, and points between the nodes of every owned segment, at most `spacing` [m] apart at rest.
std::vector<TouchSample> touch_samples(const Model& model, double spacing, TouchPoints points);

inline Vec3 place_of(const TouchSample& sample, const VecX& q) {
  return (1.0 - sample.share) * q.segment<3>(sample.coords[0]) + sample.share * q.segment<3>(sample.coords[3]);
}

}  // namespace slipstitch
