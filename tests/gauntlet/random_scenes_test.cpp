// SPDX-License-Identifier: MIT
// Random scenes hold what the gauntlet's cases hold, and there is everything in them.
#include "gauntlet/random_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>

#include "gauntlet/dice.h"
#include "gauntlet/random_runs.h"
#include "model/effect_list.h"
#include "sim/prepare.h"

namespace slipstitch::gauntlet {
namespace {

constexpr int kScenes = 300;  // that are looked at
constexpr int kRuns = 100;    // that are run
constexpr int kMostRefused = kRuns / 20;
constexpr int kMostGivenUp = 1;  // of them, where the solver is known to be weak: wraps that are damped, bends not

TEST(Dice, ThrowTheSameOnEveryPlatform) {
  Dice dice(5489);  // the seed for which the standard gives a number
  EXPECT_EQ(dice.unit(), static_cast<double>(14514284786278117030ULL >> 11) * 0x1p-53);
  EXPECT_EQ(dice.uniform(2.0, 4.0), 2.0 + 2.0 * (static_cast<double>(4620546740167642908ULL >> 11) * 0x1p-53));
}

TEST(Dice, StayInTheirRangesAndReachTheirEnds) {
  Dice dice(1);
  int lows = 0, highs = 0, small = 0;
  constexpr int kThrows = 10000;
  for (int k = 0; k < kThrows; ++k) {
    const int eye = dice.between(1, 6);
    ASSERT_TRUE(eye >= 1 && eye <= 6);
    lows += eye == 1;
    highs += eye == 6;
    const double size = dice.log_uniform(1e-3, 10.0);
    ASSERT_TRUE(size >= 1e-3 && size <= 10.0);
    small += size < 0.1;
    ASSERT_NEAR(dice.direction().norm(), 1.0, 1e-12);
  }
  EXPECT_NEAR(lows, kThrows / 6, kThrows / 60);
  EXPECT_NEAR(highs, kThrows / 6, kThrows / 60);
  EXPECT_NEAR(small, kThrows / 2, kThrows / 50);  // half of the octaves
}

bool same(const GauntletCase& a, const GauntletCase& b) {
  const Model x = prepare(a.scene).model, y = prepare(b.scene).model;
  return a.about == b.about && a.scene.duration_s == b.scene.duration_s && x.start_q == y.start_q &&
         x.start_v == y.start_v && x.load_forces == y.load_forces && x.yarn.bending_nm2 == y.yarn.bending_nm2 &&
         a.limits.max_stretch == b.limits.max_stretch;
}

TEST(RandomScenes, AreTheSameForASeedAndOthersForOthers) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_TRUE(same(random_case(seed), random_case(seed))) << seed;
    EXPECT_FALSE(same(random_case(seed), random_case(seed + 1))) << seed;
  }
}

TEST(RandomScenes, PassTheCheckOfEveryScene) {
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const GauntletCase item = random_case(seed);
    for (const Issue& issue : check(item.scene))
      ADD_FAILURE() << item.name << ": " << issue.path << " is " << issue.value << ", expected " << issue.expected;
  }
}

class Contents {
 public:
  void add(const GauntletCase& item) {
    const Scene& scene = item.scene;
    for (const std::string& effect : effect_names(scene.effects)) ++counts_[effect];
    count("at rest", !scene.effects.inertia);
    count("refusal is possible", item.limits.impossible);
    add_fabric(scene);
    for (const Handle& handle : scene.handles) add_handle(handle);
    for (const Load& load : scene.loads) ++counts_["load on " + place(load.where)];
    for (const InitialVelocity& initial : scene.initial_velocities) ++counts_["velocity of " + place(initial.where)];
    if (!scene.effects.colliders) return;
    for (const Collider& collider : scene.effects.colliders->colliders) add_collider(collider);
  }
  int count_of(const std::string& what) const { return counts_.contains(what) ? counts_.at(what) : 0; }

 private:
  void count(const char* what, bool there) { counts_[what] += there; }

  void add_fabric(const Scene& scene) {
    count("guide", !scene.guides.empty());
    count("crossing", !scene.crossings.empty());
    count("bare yarns", !scene.yarns.empty());
    if (!scene.knit) return;
    const Knit& knit = *scene.knit;
    const Repeat repeat = smallest_repeat(knit.pattern);
    count("in the round", knit.pattern.in_the_round);
    count("without repeat", repeat.courses > 2 && repeat.wales > 2);
    count("relaxed", knit.relax_repeat);
    count("drawn", !knit.relax_repeat);
    count("noise", knit.noise_m > 0.0);
    count("yarn per stitch", knit.gauge.yarn_per_stitch_m.has_value());
    count("beside a yarn", !scene.yarns.empty());
  }

  void add_handle(const Handle& handle) {
    ++counts_["handle at " + place(handle.where)];
    count("pin", handle.motion.empty() && !handle.velocity_m_per_s);
    count("keyframes", !handle.motion.empty());
    count("velocity", handle.velocity_m_per_s.has_value());
    count("arc lengths held", handle.fix_arc_length);
    count("turning handle", std::any_of(handle.motion.begin(), handle.motion.end(),
                                        [](const Keyframe& key) { return !key.rotation_rad.isZero(0.0); }));
  }

  void add_collider(const Collider& collider) {
    constexpr std::array kShapes{"plane", "sphere", "capsule", "box", "mesh"};
    const std::string shape = kShapes.at(collider.shape.index());
    if (collider.dynamic) return count("dynamic sphere", true);
    ++counts_[collider.motion.empty() ? "standing " + shape : "moving " + shape];
    count("without friction", collider.friction == 0.0);
    count("rough", collider.friction > 3.0);
  }

  static std::string place(const Selector& where) {
    constexpr std::array kPlaces{"a corner", "an edge", "stitches", "a point", "all"};
    return kPlaces.at(where.index());
  }

  std::map<std::string, int> counts_;
};

TEST(RandomScenes, HaveEverythingBetweenThem) {
  Contents contents;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) contents.add(random_case(seed));
  std::vector<std::string> wanted{"at rest",
                                  "refusal is possible",
                                  "guide",
                                  "crossing",
                                  "bare yarns",
                                  "noise",
                                  "in the round",
                                  "without repeat",
                                  "relaxed",
                                  "drawn",
                                  "pin",
                                  "yarn per stitch",
                                  "beside a yarn",
                                  "keyframes",
                                  "velocity",
                                  "rough",
                                  "arc lengths held",
                                  "without friction",
                                  "turning handle",
                                  "dynamic sphere"};
  for (const EffectEntry& effect : effect_list()) wanted.emplace_back(effect.name);
  for (const char* how : {"standing ", "moving "})
    for (const char* shape : {"plane", "sphere", "capsule", "box", "mesh"}) wanted.push_back(std::string(how) + shape);
  for (const char* what : {"handle at ", "load on ", "velocity of "})
    for (const char* place : {"a corner", "an edge", "stitches", "a point", "all"})
      wanted.push_back(std::string(what) + place);
  for (const std::string& what : wanted) EXPECT_GT(contents.count_of(what), 0) << what;
}

// Loose tails of static scenes that met bodies farther away than they were looked for, light bodies that stick, yarn
// that is stiff, yarn that was caught in yarn.
constexpr std::uint64_t kOnceFailed[] = {16, 18, 192, 196, 268, 307, 313, 336, 370, 392, 429, 474};

class OnceFailed : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(OnceFailed, HoldsNow) {
  const CellResult result = run_cell(random_case(GetParam()), {});
  EXPECT_TRUE(result.outcome == Outcome::passed || result.outcome == Outcome::cut) << result.why;
}

INSTANTIATE_TEST_SUITE_P(RandomScenes, OnceFailed, ::testing::ValuesIn(kOnceFailed),
                         [](const auto& test) { return std::to_string(test.param); });

TEST(RandomScenes, BreakNoInvariant) {
  const RandomTally tally = run_random(1, kRuns, 1, {});
  std::printf("%s", random_text(tally).c_str());
  for (const auto& failure : tally.failures)
    if (!failure.gave_up)
      ADD_FAILURE() << "seed " << failure.seed << ": " << failure.why << " (" << failure.about << ")";
  EXPECT_LE(tally.count(Outcome::refused), kMostRefused);
  EXPECT_LE(tally.gave_up(), kMostGivenUp);
}

}  // namespace
}  // namespace slipstitch::gauntlet
