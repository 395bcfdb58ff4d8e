// SPDX-License-Identifier: MIT
// How flat knits curl: side edges to the purl side, bottom and top edges to the knit side.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "swatch.h"

namespace slipstitch {
namespace {

using test::Swatch;
using test::SwatchSpec;

SwatchSpec tall(const std::string& preset, int seed) { return {preset, 18, 6, 1, seed, test::knit_effects()}; }
SwatchSpec wide(const std::string& preset, int seed) { return {preset, 6, 18, 1, seed, test::knit_effects()}; }

void print(const char* what, int seed, const Swatch& s, int group = 1) {
  std::printf("%s, seed %d: across wales %.0f /m, along wales %.0f /m, faded wraps %.3f, in the interior %.3f\n", what,
              seed, test::curvature_across_wales(s, group), test::curvature_along_wales(s, group),
              s.measured.faded_wrap_share.value(), s.measured.faded_wrap_share_interior.value());
}

constexpr int kSide = 3;  // wales at each side where the side edges curl and some yarn does run straight

class Curl : public testing::TestWithParam<int> {};

TEST_P(Curl, SidesOfTallStockinetteGoBack) {
  const Swatch s = test::swatch_at_rest(tall("stockinette", GetParam()));
  print("tall stockinette", GetParam(), s);
  EXPECT_LT(test::curvature_across_wales(s), -50.0);
}

TEST_P(Curl, EndsOfWideStockinetteComeForward) {
  const Swatch s = test::swatch_at_rest(wide("stockinette", GetParam()));
  print("wide stockinette", GetParam(), s);
  EXPECT_GT(test::curvature_along_wales(s), 50.0);
  std::printf("  faded by wale:");
  for (const double share : s.faded_by_wale) std::printf(" %.2f", share);
  std::printf("\n");
  for (int w = 1 + kSide; w <= s.wales - kSide; ++w) {
    EXPECT_EQ(s.faded_by_wale[static_cast<std::size_t>(w - 1)], 0.0) << "yarn runs straight through in wale " << w;
  }
}

TEST_P(Curl, AllPurlCurlsTheOtherWay) {
  const Swatch high = test::swatch_at_rest(tall("reverse_stockinette", GetParam()));
  const Swatch low = test::swatch_at_rest(wide("reverse_stockinette", GetParam()));
  print("tall all-purl", GetParam(), high);
  print("wide all-purl", GetParam(), low);
  EXPECT_GT(test::curvature_across_wales(high), 50.0);
  EXPECT_LT(test::curvature_along_wales(low), -50.0);
}

TEST_P(Curl, GarterLiesFlat) {
  const Swatch high = test::swatch_at_rest(tall("garter", GetParam()));
  const Swatch low = test::swatch_at_rest(wide("garter", GetParam()));
  print("tall garter", GetParam(), high, 2);
  print("wide garter", GetParam(), low, 2);
  const Swatch high_knit = test::swatch_at_rest(tall("stockinette", GetParam()));
  const Swatch low_knit = test::swatch_at_rest(wide("stockinette", GetParam()));
  EXPECT_LT(std::fabs(test::curvature_across_wales(high, 2)), std::fabs(test::curvature_across_wales(high_knit)) / 5.0);
  EXPECT_LT(std::fabs(test::curvature_along_wales(low, 2)), std::fabs(test::curvature_along_wales(low_knit)) / 5.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Curl, testing::Range(1, 6));

}  // namespace
}  // namespace slipstitch
