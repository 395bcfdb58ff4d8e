// SPDX-License-Identifier: MIT
#include "report/fabric_picture.h"

#include <gtest/gtest.h>

#include "sim/sim_scenes.h"

namespace slipstitch::testing {
namespace {

int count_of_text(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(FabricPicture, DrawsAPanelASetAndKnownBodiesOnly) {
  Scene scene = hanging_yarn();
  scene.duration_s = 0.03;
  scene.effects.colliders.emplace().colliders = {Collider{Sphere{Vec3(0.1, -0.1, 0.0), 0.02}, 0.3, {}}};
  std::vector<GrowingSet> sets = run_growing_sets(scene, 1, {}, {});
  ASSERT_EQ(sets.size(), 2U);
  const PictureBodies bodies{scene.effects.colliders->colliders, scene.duration_s};
  const std::string svg = growing_picture("a & b", sets, bodies);
  EXPECT_EQ(count_of_text(svg, "stroke-dasharray"), 1);  // the ball that the first set does not know
  EXPECT_EQ(count_of_text(svg, "fill=\"url(#body)\""), 1);
  EXPECT_EQ(count_of_text(svg, "#12344f"), 2);  // four segments of one yarn, drawn as one, twice
  EXPECT_LT(svg.find("stroke-dasharray"), svg.find("fill=\"url(#body)\""));
  EXPECT_NE(svg.find(">yarn<"), std::string::npos);
  EXPECT_NE(svg.find(">+ colliders<"), std::string::npos);
  EXPECT_NE(svg.find("a &amp; b at t = 0.03 s"), std::string::npos);
  EXPECT_EQ(svg.find("out of the picture"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  for (Eigen::Index i = 1; i < sets[0].last.q.size(); i += 3) sets[0].last.q[i] -= 10.0;
  sets[0].failure = "why";
  const std::string fallen = growing_picture("a & b", sets, bodies);
  EXPECT_NE(fallen.find("out of the picture"), std::string::npos);
  EXPECT_NE(fallen.find("stops at 0.03 s"), std::string::npos);
  EXPECT_EQ(growing_picture("nothing", {}, {}), "");
}

}  // namespace
}  // namespace slipstitch::testing
