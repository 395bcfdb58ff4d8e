// SPDX-License-Identifier: MIT
#include "model/remarks.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/knit_scene.h"

namespace slipstitch {
namespace {

// A scene without remarks.
Scene quiet_scene() {
  Scene scene = test::knit_scene("stockinette", 4, 4);
  test::use_demo_feel(scene.effects);
  scene.effects.gravity.emplace();
  scene.handles = {Handle{Edge::top, {}, false}};
  return scene;
}

struct Case {
  std::string starts_with;
  std::function<void(Scene&)> change;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"effects.gravity cannot", [](Scene& s) { s.effects.gravity->acceleration_m_per_s2.setZero(); }},
      {"effects.wrapping cannot", [](Scene& s) { s.effects.wrapping->alpha = 0.0; }},
      {"effects.sliding_friction cannot", [](Scene& s) { s.effects.sliding_friction->coefficient = 0.0; }},
      {"effects.sliding_friction cannot", [](Scene& s) { s.effects.sliding_friction->normal_force_n = 0.0; }},
      {"effects.bending_jamming cannot", [](Scene& s) { s.effects.bending_jamming->max_factor = 1.0; }},
      {"effects.damping cannot",
       [](Scene& s) {
         s.effects.damping = DampingEffect{0.0, 0.0, 0.0, 0.0};
       }},
      {"effects.air_drag cannot", [](Scene& s) { s.effects.air_drag.emplace().quadratic_ns2_per_m3 = 0.0; }},
      {"effects.wind cannot", [](Scene& s) { s.effects.air_drag.emplace(), s.effects.wind.emplace(); }},
      {"effects.shrinkage cannot",
       [](Scene& s) {
         s.effects.shrinkage.emplace().keyframes = {{0.0, 1.0}};
       }},
      {"effects.stretch is probably missing", [](Scene& s) { s.effects.stretch.reset(); }},
      {"effects.wrapping is probably missing", [](Scene& s) { s.effects.wrapping.reset(); }},
      {"effects.colliders is probably missing", [](Scene& s) { s.handles.clear(); }},
      {"effects.parallel_contact is probably missing", [](Scene& s) { s.effects.parallel_contact.reset(); }},
      {"effects.contact_length is probably missing", [](Scene& s) { s.effects.contact_length.reset(); }},
      {"effects.damping is probably missing", [](Scene& s) { s.effects.damping.reset(); }},
      {"effects.self_collision is probably missing", [](Scene& s) { s.effects.wrapping->alpha = 1.0; }},
  };
  return all;
}

TEST(Remarks, AreNoneOnASceneThatListsWhatItNeeds) { EXPECT_TRUE(remarks_on(quiet_scene()).empty()); }

TEST(Remarks, PointOutWhatCannotMatterAndWhatIsMissing) {
  for (const Case& c : cases()) {
    Scene scene = quiet_scene();
    c.change(scene);
    const std::vector<std::string> remarks = remarks_on(scene);
    ASSERT_EQ(remarks.size(), 1U) << c.starts_with;
    EXPECT_EQ(remarks[0].rfind(c.starts_with, 0), 0U) << remarks[0];
  }
}

bool says(const Scene& scene, const std::string& what) {
  for (const std::string& remark : remarks_on(scene))
    if (remark.find(what) != std::string::npos) return true;
  return false;
}

TEST(Remarks, KnowYarnThatIsASpring) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()};
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  EXPECT_TRUE(says(scene, "nothing moves the yarn"));
  Scene bent = scene;
  bent.yarns[0].points[2].y() = 0.5;
  EXPECT_FALSE(says(bent, "nothing moves the yarn"));
  bent.effects.bending.reset();
  EXPECT_TRUE(says(bent, "nothing moves the yarn"));
  scene.yarns[0].arc_lengths_m = {0.0, 0.9, 1.8};
  EXPECT_FALSE(says(scene, "nothing moves the yarn"));
}

TEST(Remarks, KnowThatOnlyWrapsAreDampedInWrapping) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()};
  scene.effects.stretch.emplace();
  scene.effects.damping = DampingEffect{0.0, 0.0, 1e-3, 0.0};
  EXPECT_TRUE(says(scene, "it damps nothing that moves"));
  scene.effects.damping->bending_nm2s = 1e-9;
  EXPECT_FALSE(says(scene, "it damps nothing that moves"));
}

TEST(Remarks, DampingMattersToStaticScenesThatScriptsMove) {
  Scene scene = quiet_scene();
  scene.effects.inertia.reset();
  EXPECT_FALSE(says(scene, "damping"));
}

TEST(Remarks, KnowThatNothingFallsWithoutWeight) {
  Scene scene = quiet_scene();
  scene.handles.clear();
  scene.effects.gravity->acceleration_m_per_s2.setZero();
  EXPECT_FALSE(says(scene, "falls onto nothing"));
}

TEST(Remarks, KnowThatWhatFallsIsNoEquilibrium) {
  Scene scene = quiet_scene();
  scene.effects.inertia.reset();
  EXPECT_FALSE(says(scene, "no equilibrium"));
  scene.handles.clear();
  EXPECT_TRUE(says(scene, "effects.inertia is probably missing"));
}

TEST(Remarks, TakeGuidesForSupports) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()};
  scene.effects.inertia.emplace();
  scene.effects.gravity.emplace();
  scene.effects.stretch.emplace();
  EXPECT_TRUE(says(scene, "falls onto nothing"));
  scene.guides = {{0, 1}};
  EXPECT_FALSE(says(scene, "falls onto nothing"));
}

TEST(Remarks, KnowWhatOnlyStitchesHave) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX()};
  scene.effects.stretch.emplace();
  scene.effects.wrapping.emplace();
  scene.effects.sliding.emplace();
  const std::vector<std::string> remarks = remarks_on(scene);
  ASSERT_EQ(remarks.size(), 3U);
  EXPECT_NE(remarks[0].find("no knit"), std::string::npos);
  EXPECT_NE(remarks[1].find("no yarn passes"), std::string::npos);
  EXPECT_NE(remarks[2].find("nothing moves the yarn"), std::string::npos);
}

TEST(Remarks, KnowThatACollidersWayCanMoveYarn) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX()};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  Collider& ball = scene.effects.colliders.emplace().colliders.emplace_back();
  ball.shape = Sphere{Vec3::UnitZ(), 0.1};
  EXPECT_EQ(remarks_on(scene).size(), 1U);
  ball.dynamic = DynamicBody{1.0, -Vec3::UnitZ()};
  EXPECT_TRUE(remarks_on(scene).empty());
  ball.dynamic.reset();
  ball.motion = {{1.0, -Vec3::UnitZ(), Vec3::Zero()}};
  EXPECT_TRUE(remarks_on(scene).empty());
}

TEST(Remarks, KnowYarnTooShortForAnEffect) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX()};
  scene.effects.stretch.emplace();
  scene.effects.bending.emplace();
  scene.effects.bending_jamming.emplace();
  scene.effects.plasticity.emplace();
  scene.effects.self_collision.emplace();
  for (const char* effect : {"bending", "bending_jamming", "plasticity", "self_collision"})
    EXPECT_TRUE(says(scene, std::string("effects.") + effect + " cannot matter")) << effect;
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX(), 3.0 * Vec3::UnitX()};
  EXPECT_FALSE(says(scene, "cannot bend"));
  EXPECT_TRUE(says(scene, "cannot meet itself"));
  scene.yarns[0].points.push_back(4.0 * Vec3::UnitX());
  EXPECT_FALSE(says(scene, "cannot meet itself"));
  scene.yarns[0].points.pop_back();
  scene.yarns.push_back(scene.yarns[0]);
  EXPECT_FALSE(says(scene, "cannot meet itself"));
}

TEST(Remarks, KnowWhatNeedsAnEffectThatCannotMatter) {
  Scene scene;
  scene.yarns.resize(1);
  scene.yarns[0].points = {Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()};
  scene.effects.stretch.emplace();
  scene.effects.sliding.emplace();
  scene.effects.sliding_friction.emplace();
  scene.guides = {{0, 1}};
  EXPECT_FALSE(says(scene, "cannot matter here: it needs"));
  scene.guides.clear();
  EXPECT_TRUE(says(scene, "effects.sliding_friction cannot matter here: it needs sliding, which cannot matter"));
}

TEST(Remarks, KnowThatNoBendYieldsAboveAHalfTurn) {
  Scene scene = quiet_scene();
  scene.effects.plasticity.emplace();
  EXPECT_FALSE(says(scene, "plasticity cannot matter"));
  scene.effects.plasticity->yield_angle_rad = 3.2;
  EXPECT_TRUE(says(scene, "effects.plasticity cannot matter here: no bend angle exceeds pi"));
}

/// Two straight yarns a centimetre apart, the first one held.
Scene two_yarns() {
  Scene scene;
  scene.yarns.resize(2);
  for (int i = 0; i < 2; ++i)
    scene.yarns[static_cast<std::size_t>(i)].points = {0.01 * i * Vec3::UnitY(),
                                                       0.01 * i * Vec3::UnitY() + Vec3::UnitX(),
                                                       0.01 * i * Vec3::UnitY() + 2.0 * Vec3::UnitX()};
  scene.effects.inertia.emplace();
  scene.effects.stretch.emplace();
  scene.handles = {Handle{YarnPoint{0, 0}, {}, false}};
  return scene;
}

TEST(Remarks, SeeThePieceThatNothingHolds) {
  Scene scene = two_yarns();
  scene.effects.gravity.emplace();
  EXPECT_TRUE(says(scene, "a piece of yarn that nothing holds falls onto nothing"));
  EXPECT_TRUE(says(scene, "effects.self_collision is probably missing"));
  Scene other = scene;
  other.handles.push_back(Handle{YarnPoint{1, 1}, {}, false});
  EXPECT_FALSE(says(other, "falls onto nothing"));
  other = scene;
  other.crossings = {{0, 1, 1, 1}};
  EXPECT_FALSE(says(other, "falls onto nothing"));
  other = scene;
  other.effects.self_collision.emplace();  // it may fall on the other yarn
  EXPECT_FALSE(says(other, "falls onto nothing"));
  EXPECT_FALSE(says(other, "self_collision is probably"));
}

TEST(Remarks, KnowThatThrownYarnPassesThroughOther) {
  Scene scene = two_yarns();
  EXPECT_FALSE(says(scene, "self_collision is probably missing"));
  scene.yarns[1].velocity_m_per_s = -Vec3::UnitY();
  EXPECT_TRUE(says(scene, "self_collision is probably missing: yarn that is thrown passes through other yarn"));
  Scene joined = scene;
  joined.crossings = {{0, 1, 1, 1}};
  EXPECT_FALSE(says(joined, "self_collision"));
  scene.effects.self_collision.emplace();
  EXPECT_FALSE(says(scene, "self_collision"));
}

TEST(Remarks, KnowThatWindTakesHoldByDrag) {
  Scene scene = quiet_scene();
  scene.effects.air_drag.emplace();
  scene.effects.wind.emplace().velocity_m_per_s = Vec3::UnitX();
  EXPECT_FALSE(says(scene, "wind cannot matter"));
  scene.effects.air_drag->linear_ns_per_m2 = 0.0;
  scene.effects.air_drag->quadratic_ns2_per_m3 = 0.0;
  EXPECT_TRUE(says(scene, "wind cannot matter"));
}

}  // namespace
}  // namespace slipstitch
