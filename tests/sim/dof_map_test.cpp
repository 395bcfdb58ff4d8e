// SPDX-License-Identifier: MIT
#include "sim/dof_map.h"

#include "sim_scenes.h"

namespace slipstitch::testing {
namespace {

int unknowns(const Scene& scene) { return make_dof_map(compile(scene, nullptr)).num_dofs; }

TEST(DofMap, GivesThreeUnknownsToAFreeNodeAndNoneToAHeldOne) {
  Scene scene = hanging_yarn();
  EXPECT_EQ(unknowns(scene), 3 * 4);
  scene.handles.clear();
  EXPECT_EQ(unknowns(scene), 3 * 5);
  scene.handles = {Handle{AllNodes{}, {}, false}};
  EXPECT_EQ(unknowns(scene), 0);
}

TEST(DofMap, GivesArcLengthsOnlyToSlidingVisits) {
  Scene scene = crossed_yarns();
  EXPECT_EQ(unknowns(scene), 3 * 8 + 2);
  scene.effects.sliding.reset();
  EXPECT_EQ(unknowns(scene), 3 * 8);
}

TEST(DofMap, KeepsTheArcLengthOfAHeldContactUnlessToldOtherwise) {
  Scene scene = crossed_yarns();
  scene.handles = {held(0, 2, false)};
  EXPECT_EQ(unknowns(scene), 3 * 8 + 2);
  scene.handles = {held(0, 2, true)};
  EXPECT_EQ(unknowns(scene), 3 * 8);
}

TEST(DofMap, GivesAGuideItsArcLengthAlone) {
  Scene scene = hanging_yarn();
  scene.effects.sliding.emplace();
  scene.guides = {{0, 2}};
  EXPECT_EQ(unknowns(scene), 3 * 3 + 1);
}

TEST(DofMap, ExpandsWhatItRestricts) {
  const Model model = compile(crossed_yarns(), nullptr);
  const DofMap map = make_dof_map(model);
  VecX y, q;
  restrict_to_dofs(map, model.start_q, y);
  expand(map, y, q);
  EXPECT_EQ(q, model.start_q);
  y = VecX::LinSpaced(map.num_dofs, 1.0, 2.0);
  expand(map, y, q);
  for (int c = 0; c < map.num_coords(); ++c) {
    const int d = map.dof_of(c);
    EXPECT_EQ(q[c], d < 0 ? model.start_q[c] : y[d]) << c;
  }
}

}  // namespace
}  // namespace slipstitch::testing
