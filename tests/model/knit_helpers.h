// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "model/knit_topology.h"

namespace slipstitch::test {

inline Knit knit_of(const std::vector<std::string>& chart, bool in_the_round = false) {
  Issues issues;
  Knit knit;
  knit.pattern = pattern_from_chart(chart, in_the_round, "chart", issues);
  EXPECT_TRUE(issues.empty());
  return knit;
}

inline Knit stockinette(int courses, int wales, bool in_the_round = false) {
  return knit_of(
      std::vector<std::string>(static_cast<std::size_t>(courses), std::string(static_cast<std::size_t>(wales), 'K')),
      in_the_round);
}

inline PlacedTopology build_drawn(const Knit& knit) {
  return build_knit(knit, drawn_cell(knit.pattern, knit.gauge, YarnMaterial{}, knit.refine));
}

inline Vec3 position(const PlacedTopology& placed, int node) {
  return placed.q.segment<3>(placed.topology.x_coord(node));
}

/// Signed wrapping angle atan2(e.(na x nb), na.nb) of (x0, x1, x3, x4).
inline double wrap_angle(const Vec3& x0, const Vec3& x1, const Vec3& x3, const Vec3& x4) {
  const Vec3 e = (x1 - x0).normalized();
  const Vec3 na = (x1 - x0).cross(x4 - x0).normalized(), nb = (x3 - x0).cross(x1 - x0).normalized();
  return std::atan2(e.dot(na.cross(nb)), na.dot(nb));
}

}  // namespace slipstitch::test
