// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "scene_io/json_parse.h"
#include "scene_io/nearest_name.h"
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

}  // namespace
}  // namespace slipstitch
