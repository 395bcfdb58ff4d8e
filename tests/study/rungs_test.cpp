// SPDX-License-Identifier: MIT
#include "study/rungs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "study/study_scenes.h"

namespace slipstitch::testing {
namespace {

std::map<std::string, std::vector<double>> sizes_by_method(const std::vector<Rung>& rungs) {
  std::map<std::string, std::vector<double>> sizes;
  for (const Rung& rung : rungs) sizes[rung.method].push_back(rung.size);
  return sizes;
}

std::set<std::string> names_of(const std::vector<Rung>& rungs) {
  std::set<std::string> names;
  for (const Rung& rung : rungs) EXPECT_TRUE(names.insert(rung_name(rung)).second) << rung_name(rung);
  return names;
}

TEST(Rungs, HalveTheStepOfEveryIntegrator) {
  const auto sizes = sizes_by_method(all_rungs(smooth_swing(), false));
  EXPECT_EQ(sizes.size(), 6U);
  for (const auto& [method, values] : sizes) {
    if (method == kAccuracyMethod) continue;
    ASSERT_EQ(values.size(), 7U) << method;
    EXPECT_NEAR(values[0], 1.0 / 60, 1e-12);
    for (std::size_t i = 1; i < values.size(); ++i) EXPECT_NEAR(values[i], 0.5 * values[i - 1], 1e-12);
  }
  EXPECT_EQ(sizes.at(std::string(kAccuracyMethod)), (std::vector<double>{1e-2, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}));
  EXPECT_EQ(names_of(all_rungs(smooth_swing(), false)).size(), 41U);
}

TEST(Rungs, BeginAtTheScenesOwnStepWhereThatIsLarger) {
  Scene scene = smooth_swing();
  scene.numerics = FixedNumerics{.time_step_s = 0.04};
  scene.frames_per_s = 10.0;
  EXPECT_NEAR(all_rungs(scene, false)[0].size, 0.1 / 3.0, 1e-12);  // frames fall on steps
  scene.frames_per_s = 100.0;
  EXPECT_NEAR(all_rungs(scene, false)[0].size, 0.01, 1e-12);  // and none is longer than a frame
}

TEST(Rungs, KeepTheRestOfTheNumerics) {
  Scene scene = smooth_swing();
  scene.numerics =
      FixedNumerics{.velocity_tolerance_m_per_s = 3e-5, .max_newton_iterations = 17, .smallest_step_s = 1e-3};
  for (const Rung& rung : ladder(scene, false)) {
    if (rung.method == kAccuracyMethod) continue;
    const auto& fixed = std::get<FixedNumerics>(rung.numerics);
    EXPECT_EQ(fixed.velocity_tolerance_m_per_s, 3e-5);
    EXPECT_EQ(fixed.max_newton_iterations, 17);
    EXPECT_LE(fixed.smallest_step_s, fixed.time_step_s);
  }
}

TEST(Rungs, ALadderHasWhatTheSceneCanBeRunWith) {
  for (const bool moves : {true, false}) {
    Scene scene = smooth_swing();
    if (!moves) {
      scene.effects.inertia.reset();
      scene.effects.damping.reset();
    }
    const std::set<std::string> used = names_of(ladder(scene, false));
    for (const Rung& rung : all_rungs(scene, false))
      EXPECT_EQ(used.contains(rung_name(rung)), check(with_rung(scene, rung)).empty()) << rung_name(rung);
    EXPECT_EQ(sizes_by_method(ladder(scene, false)).contains(std::string(kBaselineMethod)), moves);
    EXPECT_EQ(sizes_by_method(ladder(scene, false)).contains(std::string(kStaticMethod)), !moves);
  }
}

TEST(Rungs, NamesAreShort) {
  Scene scene = smooth_swing();
  EXPECT_EQ(rung_name(all_rungs(scene, false)[0]), "LINEARISED_EULER 16.7 ms");
  EXPECT_EQ(rung_name(all_rungs(scene, false)[5]), "ACCURACY 10 mm");
  scene.effects.inertia.reset();
  scene.frames_per_s = 0.5;
  scene.numerics = FixedNumerics{.time_step_s = 2.0};
  EXPECT_EQ(rung_name(all_rungs(scene, false)[0]), "STATIC 2 s 1 uN");
  EXPECT_EQ(rung_name(all_rungs(scene, false)[1]), "STATIC 2 s 30 nN");
}

TEST(Rungs, QuickIsAPartOfTheWhole) {
  std::set<std::string> whole;
  for (const Rung& rung : all_rungs(smooth_swing(), false)) whole.insert(exact_text(rung));
  const std::vector<Rung> quick = all_rungs(smooth_swing(), true);
  EXPECT_LT(quick.size(), whole.size());
  for (const Rung& rung : quick) EXPECT_TRUE(whole.contains(exact_text(rung))) << rung_name(rung);
}

TEST(Rungs, TextsDifferWhereResultsCould) {
  const Rung rung = ladder(smooth_swing(), false)[0];
  std::set<std::string> texts{exact_text(rung)};
  const auto add = [&](auto change) {
    Rung other = rung;
    change(other, std::get<FixedNumerics>(other.numerics));
    EXPECT_TRUE(texts.insert(exact_text(other)).second) << exact_text(other);
  };
  add([](Rung& other, FixedNumerics&) { other.method = "BDF2"; });
  add([](Rung&, FixedNumerics& n) { n.time_step_s = std::nextafter(n.time_step_s, 1.0); });
  add([](Rung&, FixedNumerics& n) { n.velocity_tolerance_m_per_s *= 0.5; });
  add([](Rung&, FixedNumerics& n) { n.force_tolerance_n *= 0.5; });
  add([](Rung&, FixedNumerics& n) { n.max_newton_iterations += 1; });
  add([](Rung&, FixedNumerics& n) { n.smallest_step_s *= 0.5; });
}

TEST(Rungs, RefinedOnesAreFiner) {
  const Rung rung = ladder(smooth_swing(), false)[0];
  const Rung finer = refined(rung, 0.25, 0.01);
  const auto &before = std::get<FixedNumerics>(rung.numerics), &after = std::get<FixedNumerics>(finer.numerics);
  EXPECT_EQ(after.time_step_s, 0.25 * before.time_step_s);
  EXPECT_EQ(finer.size, after.time_step_s);
  EXPECT_EQ(after.velocity_tolerance_m_per_s, 0.01 * before.velocity_tolerance_m_per_s);
  EXPECT_EQ(after.integrator, before.integrator);
  EXPECT_TRUE(check(with_rung(smooth_swing(), refined(rung, 1e-6, 1e-12))).empty());  // beyond all limits
}

}  // namespace
}  // namespace slipstitch::testing
