// SPDX-License-Identifier: MIT
#include "study/accuracy_price.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slipstitch::testing {
namespace {

RungResult rung(const std::string& method, double size, double error_m, double wall_s) {
  RungResult result;
  result.rung.method = method;
  result.rung.size = size;
  result.wall_s = wall_s;
  result.errors.emplace().position_m = error_m;
  result.errors->most_m = 0.01 * error_m * error_m;
  result.resolved = true;
  return result;
}

const std::string kBase(kBaselineMethod);

TEST(AccuracyPrice, TheFrontIsWhatNothingElseBeats) {
  std::vector<RungResult> rungs{rung("A", 1.0, 1e-2, 1.0), rung("A", 0.5, 1e-3, 4.0), rung("B", 1.0, 1e-3, 3.0),
                                rung("B", 0.5, 1e-3, 3.0), rung("C", 1.0, 2e-2, 1.0), rung("C", 0.5, 1e-4, 50.0)};
  rungs.push_back(rung("D", 1.0, std::nan(""), 0.1));                             // not compared
  rungs.push_back(rung("D", 0.5, std::numeric_limits<double>::infinity(), 0.1));  // went wild
  rungs.emplace_back().no_result = "failed";
  mark_front(rungs);
  std::vector<bool> marked;
  for (const RungResult& r : rungs) marked.push_back(r.on_front);
  EXPECT_EQ(marked, (std::vector<bool>{true, false, true, true, false, true, false, false, false}));
}

TEST(AccuracyPrice, TheBaselineIsInterpolatedInLogarithms) {
  std::vector<RungResult> rungs{rung(kBase, 1.0, 1e-2, 1.0),  rung(kBase, 0.5, 1e-4, 100.0),
                                rung(kBase, 0.7, 2e-2, 50.0),  // beaten by the first: of no use
                                rung("B", 1.0, 1e-3, 2.0),    rung("B", 0.5, 1e-5, 4.0),
                                rung("B", 2.0, 1e-1, 0.5)};
  compare_with_baseline(rungs);
  EXPECT_NEAR(rungs[0].speedup->factor, 1.0, 1e-12);
  EXPECT_NEAR(rungs[3].speedup->factor, 10.0 / 2.0, 1e-9);
  EXPECT_FALSE(rungs[3].speedup->extrapolated);
  EXPECT_NEAR(rungs[4].speedup->factor, 1000.0 / 4.0, 1e-9);  // ten times the time for a tenth of the error
  EXPECT_TRUE(rungs[4].speedup->extrapolated);
  EXPECT_NEAR(rungs[3].speedup_most->factor, 10.0 / 2.0, 1e-9);     // the same in between,
  EXPECT_NEAR(rungs[4].speedup_most->factor, 10000.0 / 4.0, 1e-6);  // but a hundredth of the error beyond
  EXPECT_NEAR(rungs[5].speedup->factor, 0.1 / 0.5, 1e-12);
  EXPECT_TRUE(rungs[5].speedup->extrapolated);
  EXPECT_NEAR(rungs[2].speedup->factor, 0.5 / 50.0, 1e-12);
}

TEST(AccuracyPrice, WithoutABaselineThereIsNoComparison) {
  std::vector<RungResult> rungs{rung("STATIC", 1.0, 1e-2, 1.0)};
  compare_with_baseline(rungs);
  EXPECT_FALSE(rungs[0].speedup);
}

TEST(AccuracyPrice, TheDefaultIsComparedAtTheErrorOfTheBaselineWithAMillisecond) {
  const std::string own(kAccuracyMethod);
  std::vector<RungResult> rungs{rung(kBase, 4.17e-3, 4e-3, 2.0), rung(kBase, 1.04e-3, 1e-3, 8.0),
                                rung(kBase, 0.52e-3, 5e-4, 16.0)};
  EXPECT_FALSE(default_gain(rungs, 1.0)) << "no run to a tolerance";
  rungs.push_back(rung(own, 1e-2, 1e-2, 1.0));
  rungs.push_back(rung(own, 1e-3, 1e-4, 4.0));
  const auto equal = default_gain(rungs, 1.0);
  ASSERT_TRUE(equal);
  EXPECT_NEAR(equal->error_m, 1e-3, 1e-15);
  EXPECT_NEAR(equal->baseline_s, 8.0, 1e-12);
  EXPECT_NEAR(equal->default_s, 2.0, 1e-9);
  EXPECT_FALSE(equal->baseline_extrapolated);
  const auto tenth = default_gain(rungs, 0.1);
  ASSERT_TRUE(tenth);
  EXPECT_NEAR(tenth->baseline_s, 80.0, 1e-9);
  EXPECT_NEAR(tenth->default_s, 4.0, 1e-9);
  EXPECT_TRUE(tenth->baseline_extrapolated);
  EXPECT_FALSE(default_gain(rungs, 0.01)) << "none of the default's is so accurate";
  EXPECT_NEAR(default_gain(rungs, 100.0)->default_s, 1.0, 1e-12) << "the coarsest, which is more accurate";
  std::erase_if(rungs, [](const RungResult& r) { return r.rung.size == 1.04e-3; });
  EXPECT_FALSE(default_gain(rungs, 1.0)) << "no baseline with a millisecond";
  rungs.push_back(rung(kBase, 1.04e-3, 5e-3, 8.0));  // worse than with longer steps
  EXPECT_NEAR(default_gain(rungs, 1.0)->baseline_s, 8.0, 1e-12);
  EXPECT_FALSE(default_gain(rungs, 1.0)->baseline_extrapolated);
}

TEST(AccuracyPrice, ADigitCostsWhatTheFrontSays) {
  // Time with the square root of 1/error, but for the last tenfold: with 1/error.
  std::vector<RungResult> rungs{rung("A", 1.0, 3e-2, 1.0), rung("A", 0.5, 3e-4, 10.0), rung("A", 0.2, 3e-5, 100.0),
                                rung("B", 1.0, 1e-3, 900.0)};  // not on the front
  mark_front(rungs);
  const std::vector<DigitPrice> digits = digit_prices(rungs);
  ASSERT_EQ(digits.size(), 2U);
  EXPECT_NEAR(digits[0].from_m, 1e-2, 1e-14);
  EXPECT_NEAR(digits[0].time_factor, std::sqrt(10.0), 1e-6);
  EXPECT_NEAR(digits[1].to_m, 1e-4, 1e-16);
  EXPECT_NEAR(digits[1].time_factor, std::pow(10.0, 0.5 * std::log10(1.0 / 0.3) + std::log10(3.0)), 1e-6);
  EXPECT_NEAR(*mean_digit_factor(rungs), std::pow(100.0, 1.0 / 3.0), 1e-9);
}

TEST(AccuracyPrice, AShortFrontHasNoPriceOfADigit) {
  std::vector<RungResult> rungs{rung("A", 1.0, 2e-2, 1.0)};
  mark_front(rungs);
  EXPECT_FALSE(mean_digit_factor(rungs));
  EXPECT_TRUE(digit_prices(rungs).empty());
  rungs.push_back(rung("A", 0.5, 1e-2, 2.0));
  mark_front(rungs);
  EXPECT_FALSE(mean_digit_factor(rungs));
  EXPECT_TRUE(digit_prices(rungs).empty());
}

TEST(AccuracyPrice, WhatIsNotResolvedHasNoDigits) {
  std::vector<RungResult> rungs{rung("A", 1.0, 3e-2, 1.0), rung("A", 0.5, 3e-4, 10.0), rung("A", 0.2, 3e-6, 20.0)};
  rungs[2].resolved = false;
  mark_front(rungs);
  EXPECT_TRUE(rungs[2].on_front);
  EXPECT_NEAR(*mean_digit_factor(rungs), std::sqrt(10.0), 1e-9);
}

TEST(AccuracyPrice, NoErrorAtAllIsAsGoodAsItGets) {
  std::vector<RungResult> rungs{rung("A", 1.0, 1e-3, 1.0), rung("A", 0.5, 0.0, 2.0)};
  mark_front(rungs);
  EXPECT_TRUE(rungs[0].on_front && rungs[1].on_front);
  EXPECT_FALSE(mean_digit_factor(rungs));
  EXPECT_TRUE(digit_prices(rungs).empty());
}

TEST(AccuracyPrice, OrdersAreOfOneMethodAndOfWhatIsResolved) {
  std::vector<RungResult> rungs{rung("A", 1.0, 1e-2, 1.0), rung("A", 0.5, 2.5e-3, 2.0), rung("B", 1.0, 1e-3, 1.0),
                                rung("B", 0.5, 5e-4, 1.0), rung("B", 0.25, 4e-4, 1.0)};
  rungs[4].resolved = false;
  set_orders(rungs);
  EXPECT_FALSE(rungs[0].order);
  EXPECT_NEAR(*rungs[1].order, 2.0, 1e-12);
  EXPECT_FALSE(rungs[2].order);
  EXPECT_NEAR(*rungs[3].order, 1.0, 1e-12);
  EXPECT_FALSE(rungs[4].order);
}

}  // namespace
}  // namespace slipstitch::testing
