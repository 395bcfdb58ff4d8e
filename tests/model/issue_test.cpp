// SPDX-License-Identifier: MIT
#include "model/issue.h"

#include <gtest/gtest.h>

#include <limits>

#include "model/pattern.h"
#include "model/scene.h"

namespace slipstitch {
namespace {

void expect_cut(const Issues& issues) {
  ASSERT_EQ(issues.size(), kMaxIssues + 1);
  EXPECT_TRUE(issues.full());
  EXPECT_NE(issues.back().expected.find("the rest is not listed"), std::string::npos);
  for (std::size_t i = 0; i < kMaxIssues; ++i) EXPECT_FALSE(issues[i].unlisted);
}

TEST(Issues, AreBoundedInNumberAndLength) {
  Issues issues;
  const std::string megabyte(1 << 20, 'x');
  for (std::size_t i = 0; i < kMaxIssues; ++i) issues.push_back({megabyte, megabyte, megabyte});
  EXPECT_EQ(issues.size(), kMaxIssues);
  EXPECT_FALSE(issues.full());
  issues.push_back({"a", "b", "c"});
  issues.push_back({"a", "b", "c"});
  expect_cut(issues);
  for (const Issue& issue : issues) EXPECT_LT(issue.path.size() + issue.value.size() + issue.expected.size(), 1500U);
}

TEST(Issues, KnowOfALimitEvenWhereItIsNotListed) {
  Issues issues;
  for (std::size_t i = 0; i < 2 * kMaxIssues; ++i) issues.push_back({"a", "b", "c"});
  EXPECT_FALSE(issues.any_too_big());
  issues.push_back({"a", "b", "c", true});
  EXPECT_TRUE(issues.any_too_big());
}

TEST(Issues, EndWithTheRestWhereverTheyAreCopied) {
  Issues issues, copy;
  for (std::size_t i = 0; i < 2 * kMaxIssues; ++i) issues.push_back({"a", "b", "c"});
  for (const Issue& issue : issues) {
    if (issue.unlisted || copy.size() < 3) copy.push_back(issue);
  }
  copy.push_back({"d", "e", "f"});
  EXPECT_EQ(copy.size(), 4U);
  EXPECT_TRUE(copy.full());
}

TEST(Issues, OfAChartEndWhereNoMoreAreListed) {
  Issues letters, lengths, after;
  pattern_from_chart({std::string(1'000'000, 'X'), std::string(1'000'000, 'Z')}, false, "rows", letters);
  expect_cut(letters);
  pattern_from_worked_rows(std::vector<std::string>(1'000'000, "K"), false, "rows", lengths);
  expect_cut(lengths);
  EXPECT_TRUE(pattern_from_chart({"KK", "KK"}, false, "rows", letters).cells.empty()) << "nobody could be told why not";
  EXPECT_TRUE(pattern_from_preset({"rib", 2, 2}, false, "preset", letters).cells.empty());
}

TEST(Issues, OfASceneAreBounded) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene;
  scene.yarns.resize(1000);
  scene.guides.resize(1000);
  scene.crossings.resize(1000);
  expect_cut(check(scene));
  scene = {};
  scene.yarns.resize(1);
  scene.yarns[0].points.assign(1000, Vec3::Constant(nan));
  expect_cut(check(scene));
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX()};
  scene.handles.resize(1);
  scene.handles[0].motion.resize(1000);
  expect_cut(check(scene));
  scene.handles.clear();
  scene.effects.colliders.emplace().colliders.resize(1);
  scene.effects.colliders->colliders[0].shape = TriangleMesh{{1000, Vec3::Zero()}, {1000, {-1, -1, -1}}};
  expect_cut(check(scene));
  scene.effects.colliders.reset();
  scene.effects.shrinkage.emplace().keyframes.resize(1000);
  expect_cut(check(scene));
}

}  // namespace
}  // namespace slipstitch
