// SPDX-License-Identifier: MIT
// Ribs draw in: their width is at most 0.8 of stockinette's.
#include <gtest/gtest.h>

#include <cstdio>

#include "swatch.h"

namespace slipstitch {
namespace {

using test::SwatchSpec;

SwatchSpec knit(const std::string& preset, int rib, int seed = 1) {
  return {preset, 6, 18, rib, seed, test::knit_effects()};
}

TEST(Rib, RelaxedRepeatIsNarrow) {
  const double flat = test::course_period(knit("stockinette", 1));
  for (const int rib : {1, 2}) {
    const double share = test::course_period(knit("rib", rib)) / flat;
    std::printf("%dx%d rib: %.3f of stockinette's %.3f mm a stitch\n", rib, rib, share, 1e3 * flat);
    EXPECT_LE(share, 0.8) << rib;
  }
}

class FreeRib : public testing::TestWithParam<int> {};

TEST_P(FreeRib, IsNarrow) {
  const double flat = test::two_stitch_distance(test::swatch_at_rest(knit("stockinette", 1, GetParam())));
  for (const int rib : {1, 2}) {
    const double share = test::two_stitch_distance(test::swatch_at_rest(knit("rib", rib, GetParam()))) / flat;
    std::printf("free %dx%d rib, seed %d: %.3f of stockinette's %.3f mm over two stitches\n", rib, rib, GetParam(),
                share, 1e3 * flat);
    EXPECT_LE(share, 0.8) << rib;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, FreeRib, testing::Range(1, 6));

}  // namespace
}  // namespace slipstitch
