// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "scene_io/convert.h"
#include "scene_io/message_json.h"
#include "scene_io/spec_hash.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

TEST(Scenes, AllLoadAndComeBackTheSame) {
  ASSERT_GE(scene_files().size(), 4u);
  for (const auto& file : scene_files()) {
    SCOPED_TRACE(file.string());
    LoadResult first = load_scene_file(file);
    ASSERT_EQ(problems(first), "");
    const v1::Scene& message = std::get<LoadedScene>(first).message;
    EXPECT_EQ(message.name(), file.stem().string());
    LoadResult second = load_scene_json(json_text(message));
    ASSERT_EQ(problems(second), "");
    EXPECT_EQ(std::get<LoadedScene>(second).message.SerializeAsString(), message.SerializeAsString());
    EXPECT_EQ(json_text(std::get<LoadedScene>(second).message), json_text(message));
    EXPECT_EQ(message_hash(std::get<LoadedScene>(second).message), message_hash(message));
    LoadResult third = load_scene_message(message);
    ASSERT_EQ(problems(third), "");
    EXPECT_EQ(difference(std::get<LoadedScene>(third).message, message), "");
  }
}

TEST(Scenes, DefaultsWrittenOutDoNotChangeTheHash) {
  LoadResult plain = load_scene_json(good_scene());
  LoadResult spelled = load_scene_json(good_scene(R"(, "duration_s": 1, "yarn": {"stretch_n": 68}, "fixed": {})"));
  LoadResult other = load_scene_json(good_scene(R"(, "duration_s": 1.0000000000000002)"));
  ASSERT_EQ(problems(plain) + problems(spelled) + problems(other), "");
  EXPECT_EQ(message_hash(std::get<LoadedScene>(plain).message), message_hash(std::get<LoadedScene>(spelled).message));
  EXPECT_NE(message_hash(std::get<LoadedScene>(plain).message), message_hash(std::get<LoadedScene>(other).message));
}

TEST(Scenes, TheDemoIsWhatIsPromised) {
  LoadResult result = load_scene_file(SLIPSTITCH_SOURCE_DIR "/scenes/stockinette-drape.json");
  ASSERT_EQ(problems(result), "");
  const Scene& scene = std::get<LoadedScene>(result).scene;
  EXPECT_EQ(scene.knit->pattern.courses, 40);
  EXPECT_EQ(scene.knit->pattern.wales, 40);
  EXPECT_EQ(std::count(scene.knit->pattern.cells.begin(), scene.knit->pattern.cells.end(), StitchKind::knit), 1600);
  EXPECT_EQ(scene.knit->placement.course_direction.y(), 0.0);  // horizontal
  EXPECT_EQ(scene.knit->placement.wale_direction.y(), 0.0);
  EXPECT_TRUE(scene.effects.gravity && scene.effects.sliding && scene.effects.sliding_friction);
  EXPECT_EQ(scene.duration_s, 2.0);
  EXPECT_EQ(scene.frames_per_s, 30.0);
  EXPECT_LE(std::get<FixedNumerics>(scene.numerics).time_step_s, 1.0 / 120);
  EXPECT_LE(std::get<FixedNumerics>(scene.numerics).velocity_tolerance_m_per_s, 1e-4);
}

}  // namespace
}  // namespace slipstitch
