// SPDX-License-Identifier: MIT
#include "report/effect_notes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "model/effect_list.h"

namespace slipstitch::test {
namespace {

TEST(EffectNotes, SayOfEveryEffectWhatItIsAndWhatIsWrongWithoutIt) {
  std::set<std::string_view> texts;
  for (const EffectEntry& effect : effect_list()) {
    const std::string_view note = effect_note(effect.name);
    EXPECT_GT(note.size(), 100U) << effect.name;
    EXPECT_NE(note.find("Without"), std::string_view::npos) << effect.name;
    EXPECT_NE(note.find("need"), std::string_view::npos) << effect.name;
    EXPECT_NE(note.find("cost"), std::string_view::npos) << effect.name;
    texts.insert(note);
  }
  EXPECT_EQ(texts.size(), effect_list().size());
  EXPECT_NE(effect_notes_markdown().find(handles_note()), std::string::npos);
  EXPECT_TRUE(effect_note("no such effect").empty());
}

TEST(EffectNotes, StandInTheDocumentInTheOrderOfTheList) {
  const std::string text = effect_notes_markdown();
  std::size_t at = 0;
  for (const EffectEntry& effect : effect_list()) {
    const std::size_t found = text.find("**" + std::string(effect.name) + "**");
    ASSERT_NE(found, std::string::npos) << effect.name;
    EXPECT_GE(found, at);
    at = found;
  }
}

TEST(EffectNotes, TheDocumentIsOfThisVersion) {
  std::ifstream file(SLIPSTITCH_SOURCE_DIR "/docs/effects.md");
  const std::string document((std::istreambuf_iterator<char>(file)), {});
  EXPECT_NE(document.find(effect_notes_markdown()), std::string::npos) << "make it again: ./run docs";
  for (const char* scene : {"drape", "stretch", "curl", "ball-drop", "torso"})
    EXPECT_NE(document.find("\n## " + std::string(scene) + "\n"), std::string::npos) << scene;
}

}  // namespace
}  // namespace slipstitch::test
