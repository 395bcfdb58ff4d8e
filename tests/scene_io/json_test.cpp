// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_io/json_parse.h"
#include "scene_io/nearest_name.h"
#include "scene_io/read_message.h"
#include "scene_io/spec_hash.h"
#include "scene_text.h"

namespace slipstitch {
namespace {

TEST(Json, EveryValueKnowsItsPlace) {
  const std::string text = "{\"a\": [1,\n -2.5e3 ,\"\\u00e9\\\"\"], \"b\":{\"c\":true,\"d\" : [ ] }}";
  Issues issues;
  std::optional<JsonNode> root = parse_json(text, issues);
  ASSERT_TRUE(root);
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(text.substr(nearest_node(*root, "a").offset, 2), "[1");
  EXPECT_EQ(text.substr(nearest_node(*root, "a[0]").offset, 2), "1,");
  EXPECT_EQ(text.substr(nearest_node(*root, "a[1]").offset, 6), "-2.5e3");
  EXPECT_EQ(text.substr(nearest_node(*root, "a[2]").offset, 7), "\"\\u00e9");
  EXPECT_EQ(text.substr(nearest_node(*root, "b").offset, 4), "{\"c\"");
  EXPECT_EQ(text.substr(nearest_node(*root, "b.c").offset, 4), "true");
  EXPECT_EQ(text.substr(nearest_node(*root, "b.d").offset, 3), "[ ]");
  EXPECT_EQ(nearest_node(*root, "b.d[4].e").offset, nearest_node(*root, "b.d").offset);
  EXPECT_EQ(std::get<std::string>(nearest_node(*root, "a[2]").value), "\xc3\xa9\"");
}

TEST(Json, ColumnsCountCharacters) {
  TextPlace place = place_of("ab\n\xc3\xa9\xc3\xa9x", 7);
  EXPECT_EQ(place.line, 2);
  EXPECT_EQ(place.column, 3);
}

TEST(Json, IntegersStayExact) {
  Issues issues;
  std::optional<JsonNode> root = parse_json("[18446744073709551615, 9007199254740993, -9223372036854775808]", issues);
  ASSERT_TRUE(root);
  EXPECT_EQ(std::get<std::uint64_t>(nearest_node(*root, "[0]").value), 18446744073709551615u);
  EXPECT_EQ(std::get<std::int64_t>(nearest_node(*root, "[1]").value), 9007199254740993);
  EXPECT_EQ(std::get<std::int64_t>(nearest_node(*root, "[2]").value), std::numeric_limits<std::int64_t>::min());
}

TEST(Json, SixtyFourLevelsAreFine) {
  Issues issues;
  EXPECT_TRUE(parse_json(std::string(64, '[') + std::string(64, ']'), issues)) << issue_lines(issues);
}

TEST(Json, TheFirstOfDuplicateKeysIsKept) {
  Issues issues;
  std::optional<JsonNode> root = parse_json(R"({"a": 1, "a": {"b": [2]}, "c": 3})", issues);
  ASSERT_TRUE(root);
  EXPECT_EQ(issues.size(), 1u);
  EXPECT_EQ(std::get<std::int64_t>(nearest_node(*root, "a").value), 1);
  EXPECT_EQ(std::get<std::int64_t>(nearest_node(*root, "c").value), 3);
}

std::string repeated(const std::string& text, long times) {
  std::string result;
  for (long i = 0; i < times; ++i) result += text;
  return result;
}

// A short text could else take gigabytes.
TEST(Json, HasALimitOfValues) {
  const auto problem = [](const std::string& text) {
    Issues issues;
    const bool read = parse_json(text, issues).has_value();
    EXPECT_EQ(read, issues.empty());
    return issues.empty() ? Issue() : issues[0];
  };
  EXPECT_EQ(problem("{\"a\": [" + repeated("0,", kMaxJsonValues - 21) + "0]}").expected, "");
  const Issue numbers = problem("{\"a\": [" + repeated("0,", kMaxJsonValues - 20) + "0]}");
  EXPECT_EQ(numbers.path, "a");
  EXPECT_EQ(numbers.expected, "at most 8000000 values");
  EXPECT_TRUE(numbers.too_big);
  EXPECT_EQ(numbers.limit, kMaxJsonValues);
  EXPECT_TRUE(problem("[" + repeated("{},", kMaxJsonValues / 10) + "0]").too_big);
}

TEST(Json, NearestNames) {
  const std::vector<std::string> known{"radius_m", "stretch_n", "bending_nm2"};
  EXPECT_EQ(nearest_name("radiusM", known), "radius_m");
  EXPECT_EQ(nearest_name("strech_n", known), "stretch_n");
  EXPECT_EQ(nearest_name("colour", known), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'a'), known), "");
  EXPECT_EQ(one_of(known), "radius_m, stretch_n or bending_nm2");
}

/// SHA-256 of the bytes 0a 01 61, from sha256sum.
TEST(Json, HashIsSha256OfTheSerialisation) {
  v1::Scene scene;
  scene.set_name("a");
  EXPECT_EQ(message_hash(scene), "23dca2a7429612378554b0bb5b85012dec00a17cc2c673f17d2b76a50b839cd5");
  v1::Scene other = scene;
  other.set_duration_s(0.0);  // present, though zero
  EXPECT_NE(message_hash(other), message_hash(scene));
}

// As protobuf's JSON mapping writes 64-bit integers.
TEST(Json, WideIntegersMayBeTexts) {
  const auto seed = [](const std::string& value) {
    Issues issues;
    v1::Knit knit;
    const std::string text = "{\"noise_seed\": " + value + "}";
    read_message(*parse_json(text, issues), text, knit, issues);
    return issues.empty() ? std::to_string(knit.noise_seed()) : issue_lines(issues);
  };
  EXPECT_EQ(seed("\"18446744073709551615\""), "18446744073709551615");
  EXPECT_EQ(seed("7"), "7");
  for (const char* wrong : {"\"\"", "\"-1\"", "\"7 \"", "\"7.0\"", "\"18446744073709551616\"", "\"0x7\""}) {
    EXPECT_NE(seed(wrong).find("expected a whole number"), std::string::npos) << seed(wrong);
  }
}

}  // namespace
}  // namespace slipstitch
