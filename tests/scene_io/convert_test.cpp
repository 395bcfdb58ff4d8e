// SPDX-License-Identifier: MIT
#include "scene_io/convert.h"

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <set>

#include "model/effect_list.h"
#include "scene_io/json_parse.h"
#include "scene_io/message_json.h"
#include "scene_io/read_message.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

/// Sets every field of a message to a value of its own, never a default; of each oneof the choice of turn `turn`.
class Filler {
 public:
  explicit Filler(int turn) : turn_(turn) {}

  void fill(Message& message) {
    const Descriptor& type = *message.GetDescriptor();
    for (int i = 0; i < type.field_count(); ++i) {
      const FieldDescriptor& field = *type.field(i);
      const auto* oneof = field.real_containing_oneof();
      const int choices = oneof != nullptr ? oneof->field_count() : 1;
      if (oneof != nullptr && oneof->field(turn_ / outer_choices_ % choices) != &field) continue;
      set_.insert(field.full_name());
      outer_choices_ *= choices;
      field.is_repeated() ? fill_repeated(message, field) : fill_singular(message, field);
      outer_choices_ /= choices;
    }
  }

  const std::set<std::string>& fields() const { return set_; }

 private:
  double next() { return 0.5 + count_++; }

  void fill_repeated(Message& message, const FieldDescriptor& field) {
    const auto& to = *message.GetReflection();
    int length = field.name() == "points_m" ? 6 : 3;
    for (int i = 0; i < length; ++i) {
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) to.AddDouble(&message, &field, next());
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_STRING) to.AddString(&message, &field, i == 1 ? "KPKK" : "PKKP");
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) fill(*to.AddMessage(&message, &field));
    }
  }

  void fill_singular(Message& message, const FieldDescriptor& field) {
    const auto& to = *message.GetReflection();
    switch (field.cpp_type()) {
      case FieldDescriptor::CPPTYPE_DOUBLE:
        to.SetDouble(&message, &field, next());
        break;
      case FieldDescriptor::CPPTYPE_INT32:
        to.SetInt32(&message, &field, static_cast<int>(next()) + 2);
        break;
      case FieldDescriptor::CPPTYPE_UINT64:
        to.SetUInt64(&message, &field, ~std::uint64_t{0} - 3);
        break;
      case FieldDescriptor::CPPTYPE_BOOL:
        to.SetBool(&message, &field, field.name() != "relax_repeat");
        break;
      case FieldDescriptor::CPPTYPE_ENUM:
        to.SetEnumValue(&message, &field, 1 + (turn_ + count_++) % 4);
        break;
      case FieldDescriptor::CPPTYPE_STRING:
        to.SetString(&message, &field, message.GetTypeName().ends_with("Preset") ? "seed" : "drape");
        break;
      case FieldDescriptor::CPPTYPE_MESSAGE:
        fill(*to.MutableMessage(&message, &field));
        break;
      default:
        FAIL() << "the schema has a new kind of field: " << field.full_name();
    }
  }

  int turn_;
  int outer_choices_ = 1;  // of the oneofs that it is within
  int count_ = 1;
  std::set<std::string> set_;
};

void collect_fields(const Descriptor& type, std::set<std::string>& names) {
  for (int i = 0; i < type.field_count(); ++i) {
    names.insert(type.field(i)->full_name());
    if (type.field(i)->message_type() != nullptr) collect_fields(*type.field(i)->message_type(), names);
  }
}

v1::Scene there_and_back(const v1::Scene& message) {
  Issues issues;
  Scene scene = scene_from_message(message, issues);
  EXPECT_TRUE(issues.empty()) << issue_lines(issues);
  return message_from_scene(scene);
}

constexpr int kTurns = 60;  // every choice of every oneof: of 2, 3 and 5, and of 2 within 2

TEST(Convert, EveryFieldOfASceneSurvives) {
  std::set<std::string> seen;
  for (int turn = 0; turn < kTurns; ++turn) {
    v1::Scene message;
    Filler filler(turn);
    filler.fill(message);
    seen.insert(filler.fields().begin(), filler.fields().end());
    v1::Scene back = there_and_back(message);
    if (!message.knit().has_chart()) {  // presets and worked rows come back as the chart they mean
      ASSERT_TRUE(back.knit().has_chart());
      *message.mutable_knit()->mutable_chart() = back.knit().chart();
    }
    ASSERT_EQ(difference(message, back), "") << "turn " << turn;
  }
  std::set<std::string> all;
  collect_fields(*v1::Scene::descriptor(), all);
  EXPECT_EQ(seen, all);
}

TEST(Convert, EveryFieldSurvivesJson) {
  for (int turn = 0; turn < kTurns; ++turn) {
    v1::Scene message, back;
    Filler(turn).fill(message);
    Issues issues;
    std::string text = json_text(message);
    auto root = parse_json(text, issues);
    ASSERT_TRUE(root) << issue_lines(issues);
    read_message(*root, text, back, issues);
    ASSERT_TRUE(issues.empty()) << issue_lines(issues);
    ASSERT_EQ(difference(message, back), "");
    ASSERT_EQ(message.SerializeAsString(), back.SerializeAsString());  // bit for bit
    ASSERT_EQ(json_text(back), text);
  }
}

TEST(Convert, AnEmptyMessageHasTheDefaultsOfTheCore) {
  EXPECT_EQ(difference(there_and_back(v1::Scene()), message_from_scene(Scene())), "");
  v1::Scene all_on;  // empty messages everywhere
  Scene expected;
  auto& effects = *all_on.mutable_effects();
  for (int i = 0; i < v1::Effects::descriptor()->field_count(); ++i) {
    effects.GetReflection()->MutableMessage(&effects, v1::Effects::descriptor()->field(i));
  }
  expected.effects.automatic.emplace();
  for (const EffectEntry& effect : effect_list()) effect.add(expected.effects);
  EXPECT_EQ(difference(there_and_back(all_on), message_from_scene(expected)), "");
}

TEST(Convert, TheSchemaHasTheEffectsOfTheCoreByTheirNames) {
  std::set<std::string> schema, core{"auto"};
  for (int i = 0; i < v1::Effects::descriptor()->field_count(); ++i)
    schema.insert(v1::Effects::descriptor()->field(i)->name());
  for (const EffectEntry& effect : effect_list()) core.insert(effect.name);
  EXPECT_EQ(schema, core);
}

TEST(Convert, PresetsAndWorkedRowsMeanTheirCharts) {
  v1::Scene message;
  message.mutable_knit()->mutable_preset()->set_name("garter");
  message.mutable_knit()->mutable_preset()->set_courses(3);
  message.mutable_knit()->mutable_preset()->set_wales(2);
  auto rows = there_and_back(message).knit().chart().rows();
  EXPECT_EQ(std::vector<std::string>(rows.begin(), rows.end()), (std::vector<std::string>{"KK", "PP", "KK"}));
  auto& worked = *message.mutable_knit()->mutable_worked_rows();
  for (const char* row : {"KP", "KP", "KK"}) worked.add_rows(row);
  rows = there_and_back(message).knit().chart().rows();
  EXPECT_EQ(std::vector<std::string>(rows.begin(), rows.end()), (std::vector<std::string>{"KK", "PK", "PK"}));
}

}  // namespace
}  // namespace slipstitch
