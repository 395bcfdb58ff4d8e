// SPDX-License-Identifier: MIT
#include "study/growing_sets.h"

#include <gtest/gtest.h>

#include <set>

#include "model/effect_list.h"
#include "sim/sim_scenes.h"

namespace slipstitch::testing {
namespace {

TEST(GrowingSets, EveryEffectIsInOneStageAfterWhatItNeeds) {
  std::set<std::string> seen;
  for (const EffectStage& stage : effect_stages()) {
    for (const std::string& name : stage.effects) {
      ASSERT_NE(find_effect(name), nullptr) << name;
      EXPECT_TRUE(seen.insert(name).second) << name;
    }
    for (const std::string& name : stage.effects) {
      const std::string needs = find_effect(name)->needs;
      EXPECT_TRUE(needs.empty() || seen.contains(needs)) << name;
    }
  }
  EXPECT_EQ(seen.size(), effect_list().size());
}

TEST(GrowingSets, AddOneStageAfterTheOtherUpToTheScene) {
  Scene scene = crossed_yarns();
  scene.duration_s = 0.05;
  scene.effects.sliding_friction.emplace();
  const std::vector<GrowingSet> sets = run_growing_sets(scene, 1, {}, {});
  ASSERT_EQ(sets.size(), 2U);
  EXPECT_EQ(sets[0].added, (std::vector<std::string>{"inertia", "gravity", "stretch", "bending"}));
  EXPECT_EQ(sets[1].added, (std::vector<std::string>{"sliding", "sliding_friction"}));
  EXPECT_EQ(sets[1].failure, "");
  Frame last;
  RunHooks hooks;
  hooks.on_frame = [&](const Frame& frame) { last = frame; };
  run(scene, 1, hooks);
  EXPECT_EQ(sets[1].last.q, last.q);  // the same bits as the scene itself
  EXPECT_NE(sets[0].last.q, last.q);
}

TEST(GrowingSets, StopBetweenTheSets) {
  int asked = 0;
  Scene scene = crossed_yarns();
  scene.duration_s = 0.01;
  const auto sets = run_growing_sets(
      scene, 1, [&](int, int) { ++asked; }, [&] { return asked > 0; });
  EXPECT_EQ(asked, 1);
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].failure, "stopped");
}

}  // namespace
}  // namespace slipstitch::testing
