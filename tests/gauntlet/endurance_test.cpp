// SPDX-License-Identifier: MIT
// What rests stays, what is pushed moves and comes back, what creeps is not held up by tolerances.
#include "gauntlet/endurance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace slipstitch::gauntlet {
namespace {

TEST(Endurance, WhatRestsStaysWhereItIs) {
  const Rest found = rest(3000, {});
  std::printf("%s", rest_text(found).c_str());
  EXPECT_LT(found.farthest_m, 1e-9);
}

TEST(Endurance, AThousandthOfARadiusIsSeenAndDiesOut) {
  RestingSwatch swatch(Friction::off);
  const double way = 1e-3 * swatch.radius_m(), least = swatch.energy();
  swatch.kick(way);
  const double given = swatch.energy() - least;
  double fastest = 0.0, energy = swatch.energy();
  swatch.advance(240, [&] {
    fastest = std::max(fastest, swatch.speed());
    EXPECT_LE(swatch.energy(), energy + 1e-12 * least);
    energy = swatch.energy();
  });
  std::printf("%.1e J given, speeds up to %.1e m/s; a second later %.1e of it, %.1e m/s\n", given, fastest,
              (swatch.energy() - least) / given, swatch.speed());
  EXPECT_GT(fastest, way);  // a second would be enough
  EXPECT_LT(swatch.energy() - least, 0.02 * given);
  EXPECT_LT(swatch.speed(), 0.05 * fastest);
}

TEST(Endurance, WhatCreepsIsNotHeldUpByTheTolerance) {
  const Crept usual = crept(1.0), exact = crept(1e-4);
  std::printf("%.3e m in 0.1 s, %.3e m at a tolerance ten thousand times tighter, nodes at %.1e m/s\n", usual.mean_m,
              exact.mean_m, exact.fastest_m_per_s);
  EXPECT_LT(exact.fastest_m_per_s, 0.5 * FixedNumerics{}.velocity_tolerance_m_per_s)
      << "nothing moves so fast that a step must be taken for it";
  EXPECT_GT(exact.mean_m, 1e-12);
  EXPECT_NEAR(usual.mean_m, exact.mean_m, 0.05 * exact.mean_m);
}

}  // namespace
}  // namespace slipstitch::gauntlet
