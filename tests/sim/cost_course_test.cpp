// SPDX-License-Identifier: MIT
#include "sim/cost_course.h"

#include <gtest/gtest.h>

namespace slipstitch {
namespace {

TEST(CostCourse, KnowsNothingAtFirst) {
  EXPECT_EQ(CostCourse(1.0, 1e-6).wall_s(0.0, 1.0, 1e-6), 0.0);
  EXPECT_EQ(CostCourse(0.0, 1e-6).known_until_s(), 0.0);
}

TEST(CostCourse, GivesBackWhatItWasToldAndScalesIt) {
  CostCourse course(2.0, 1e-9);
  course.add({0.0, 0.5, 3.0, 1e-4, 1.0});
  course.add({0.5, 2.0, 6.0, 1e-4, 0.0});
  EXPECT_NEAR(course.wall_s(0.0, 2.0, 1e-4), 9.0, 1e-9);
  EXPECT_NEAR(course.wall_s(0.25, 1.25, 1e-4), 1.5 + 3.0, 1e-9);
  EXPECT_NEAR(course.wall_s(0.0, 2.0, 1e-6), 90.0, 1e-9);
  EXPECT_NEAR(course.wall_s(0.0, 2.0, 1e-2), 3.0 + 0.6, 1e-9) << "the first pair cannot be longer";
}

TEST(CostCourse, GoesOnAsInTheLastHalf) {
  CostCourse course(2.0, 1e-9);
  course.add({0.0, 0.5, 100.0, 1e-4, 1.0});
  course.add({0.5, 1.0, 2.0, 1e-4, 1.0});
  EXPECT_EQ(course.known_until_s(), 1.0);
  EXPECT_NEAR(course.wall_s(1.0, 2.0, 1e-4), 4.0, 1e-9);
}

TEST(CostCourse, DoesNotTrustMotionThatHadNoErrors) {
  CostCourse course(2.0, 1e-5);
  course.add({0.0, 1.0, 5.0, 1e-15, 1.0});
  EXPECT_NEAR(course.wall_s(0.0, 1.0, 1e-7), 5.0, 1e-9) << "what is known stays";
  EXPECT_NEAR(course.wall_s(1.0, 2.0, 1e-7), 50.0, 1e-9);
  EXPECT_NEAR(course.wall_s(1.0, 2.0, 1e-5), 5.0, 1e-9);
}

}  // namespace
}  // namespace slipstitch
