// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "scene_text.h"

namespace slipstitch {
namespace {

const std::vector<std::string> kPieces{"{",
                                       "}",
                                       "[",
                                       "]",
                                       ",",
                                       ":",
                                       "\"",
                                       "null",
                                       "true",
                                       "-1",
                                       "1e308",
                                       "1e999",
                                       "\\u00",
                                       "\"NaN\"",
                                       "\"knit\":",
                                       "\"effects\":",
                                       "0",
                                       "{}",
                                       "\xff",
                                       "\\",
                                       "9999999999999999999999",
                                       "\"rows\":",
                                       "-",
                                       ".",
                                       "\n"};

/// Damage of one to four places: bytes changed, cut, doubled or replaced by pieces of JSON.
std::string damaged(std::string text, std::mt19937& random) {
  auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (std::size_t cuts = 1 + below(4); cuts > 0 && !text.empty(); --cuts) {
    std::size_t at = below(text.size());
    std::size_t length = std::min(text.size() - at, 1 + below(12));
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.replace(at, length, kPieces[below(kPieces.size())]);
        break;
      default:
        text.insert(at, kPieces[below(kPieces.size())]);
    }
  }
  return text;
}

TEST(Mutation, EveryTextIsASceneOrHasProblems) {
  std::vector<std::string> seeds{good_scene(), good_scene(R"(, "handles": [{"where": {"corner": "TOP_LEFT"}}])")};
  for (const auto& file : scene_files()) seeds.push_back(file_content(file));
  std::mt19937 random(20261122);
  int scenes = 0, refused = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = damaged(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
    LoadResult result = load_scene_json(text);
    if (const auto* issues = std::get_if<Issues>(&result)) {
      ++refused;
      ASSERT_FALSE(issues->empty()) << text;
      for (const Issue& issue : *issues) ASSERT_FALSE(issue.expected.empty()) << text;
    } else {
      ++scenes;
      const v1::Scene& message = std::get<LoadedScene>(result).message;
      ASSERT_EQ(problems(load_scene_message(message)), "") << text;
    }
  }
  EXPECT_GT(scenes, 40);
  EXPECT_GT(refused, 2000);
}

}  // namespace
}  // namespace slipstitch
