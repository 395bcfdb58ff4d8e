// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "scene_io/json_tree.h"
#include "scene_text.h"
#include "support/sample_run.h"

namespace slipstitch {
namespace {

struct BadInput {
  const char* name;
  std::string text;
  std::string path;      // of the problem
  std::string fragment;  // of its line as a user reads it
  int line = 0, column = 0;
  bool too_big = false;
};

void PrintTo(const BadInput& bad, std::ostream* out) { *out << bad.name; }

std::string with_rows(const std::string& rows) {
  return R"({"knit": {"chart": {"rows": )" + rows + R"(}, "gauge": {"yarn_per_stitch_m": 0.011}}})";
}

std::string with_collider(const std::string& collider, const std::string& effects = R"("inertia": {}, )") {
  std::string text = good_scene();
  return text.insert(text.find("\"stretch\""), effects + "\"colliders\": {\"colliders\": [\n" + collider + "]}, ");
}

std::string nested(int depth) { return std::string(static_cast<std::size_t>(depth), '['); }

std::vector<BadInput> bad_inputs() {
  return {
      {"empty", "", "", "valid JSON", 1, 1},
      {"not_json", "stockinette", "", "valid JSON", 1, 1},
      {"cut_off", R"({"name": "a)", "name", "valid JSON", 1, 12},
      {"single_quotes", "{'name': 1}", "", "valid JSON", 1, 2},
      {"trailing_comma", "{\n  \"name\": \"a\",\n}", "name", "valid JSON", 3, 1},
      {"trailing_text", "{} {}", "", "valid JSON", 1, 4},
      {"bad_utf8", "{\"name\": \"\xff\"}", "name", "valid JSON", 1, 11},
      {"number_overflow", R"({"duration_s": 1e999})", "duration_s", "valid JSON: number overflow parsing '1e999'", 1,
       20},
      {"bare_nan", R"({"duration_s": NaN})", "duration_s", "valid JSON", 1, 16},
      {"nested_100000", nested(100000), "[0]", "at most 64 levels", 1, 65},
      {"nested_objects", R"({"knit":)" + nested(64), "knit", "at most 64 levels", 1, 72},
      {"not_an_object", "[1, 2]", "", "is an array of 2, expected an object", 1, 1},
      {"duplicate_key", good_scene(",\n  \"name\": \"a\",\n  \"name\": \"b\""), "name", "each key once", 8, 3},
      {"unknown_field", good_scene(",\n  \"yarn\": {\"radiu_m\": 1}"), "yarn.radiu_m",
       "did you mean \"radius_m\"? (line 7, column 12)", 7, 12},
      {"far_from_any_field", good_scene(R"(, "numerics_of_everything": 1)"), "numerics_of_everything",
       "expected a field of Scene: name, knit,", 6, 31},
      {"camel_case", good_scene(R"(, "framesPerS": 30)"), "framesPerS", "did you mean \"frames_per_s\"?", 6, 31},
      {"null", good_scene(R"(, "duration_s": null)"), "duration_s",
       "is null, expected a finite number; leave the field out for its default", 6, 45},
      {"null_message", good_scene(R"(, "yarn": null)"), "yarn", "is null, expected an object; leave", 6, 39},
      {"nan_string", good_scene(R"(, "duration_s": "NaN")"), "duration_s", "is \"NaN\", expected a finite number, not",
       6, 45},
      {"infinity_string", good_scene(R"(, "duration_s": "-Infinity")"), "duration_s",
       "is \"-Infinity\", expected a finite", 6, 45},
      {"number_as_string", good_scene(R"(, "duration_s": "2")"), "duration_s",
       "is \"2\", expected a finite number, not", 6, 45},
      {"bool_as_number", good_scene(R"(, "handles": [{"where": {"all": {}}, "fix_arc_length": 1}])"),
       "handles[0].fix_arc_length", "is 1, expected true or false", 6, 84},
      {"enum_number", good_scene(R"(, "handles": [{"where": {"corner": 3}}])"), "handles[0].where.corner",
       "is 3, expected \"BOTTOM_LEFT\", \"BOTTOM_RIGHT\", \"TOP_LEFT\" or \"TOP_RIGHT\"", 6, 64},
      {"enum_name", good_scene(R"(, "handles": [{"where": {"corner": "top_left"}}])"), "handles[0].where.corner",
       "is \"top_left\", expected \"BOTTOM_LEFT\"", 6, 64},
      {"enum_unspecified", good_scene(R"(, "handles": [{"where": {"corner": "CORNER_UNSPECIFIED"}}])"),
       "handles[0].where.corner", "expected \"BOTTOM_LEFT\"", 6, 64},
      {"fraction_as_integer", good_scene(R"(, "guides": [{"yarn": 1.5}])"), "guides[0].yarn",
       "is 1.5, expected a whole number from -2147483648 to 2147483647", 6, 51},
      {"integer_too_large", good_scene(R"(, "guides": [{"yarn": 2147483648}])"), "guides[0].yarn",
       "is 2147483648, expected", 6, 51},
      {"unsigned_negative", good_scene().insert(good_scene().find("\"chart\""), "\"noise_seed\": -1,\n    "),
       "knit.noise_seed", "is -1, expected a whole number from 0 to 18446744073709551615", 3, 19},
      {"array_as_object", good_scene(R"(, "handles": {"where": {}})"), "handles", "is an object, expected an array", 6,
       42},
      {"object_as_array", good_scene(R"(, "yarn": [])"), "yarn", "is an array of 0, expected an object", 6, 39},
      {"string_as_number", good_scene(R"(, "name": 3)"), "name", "is 3, expected a string", 6, 39},
      {"two_choices", good_scene(R"(, "fixed": {}, "accuracy": {})"), "accuracy",
       "is a second choice beside \"fixed\", expected only one of them", 6, 44},
      {"vector_length", good_scene(R"(, "loads": [{"where": {"all": {}}, "force_n": [1, 2]}])"), "loads[0].force_n",
       "is an array of 2, expected 3 numbers: [x, y, z]", 6, 75},
      {"points_length", R"({"yarns": [{"points_m": [0, 0, 0, 1]}]})", "yarns[0].points_m", "a multiple of 3 numbers", 1,
       25},
      {"no_selector", good_scene(R"(, "handles": [{"where": {}}])"), "handles[0].where",
       "expected one of corner, edge, stitches, yarn_point and all", 6, 53},
      {"no_pattern", R"({"knit": {"gauge": {"yarn_per_stitch_m": 0.011}}})", "knit",
       "expected chart, preset or worked_rows", 1, 10},
      {"row_length", with_rows(R"(["KKK", "KK", "KKK"])"), "knit.chart.rows[1]", "is 2 stitches, expected 3 stitches",
       1, 37},
      {"unknown_stitch", with_rows(R"(["KK", "KX"])"), "knit.chart.rows[1]", "is X in column 2, expected K or P", 1,
       36},
      {"one_row", with_rows(R"(["KK"])"), "knit.chart.rows", "is 1 rows, expected at least 2 rows", 1, 29},
      {"unknown_preset", R"({"knit": {"preset": {"name": "cable", "courses": 4, "wales": 4},
        "gauge": {"yarn_per_stitch_m": 0.011}}})",
       "knit.preset.name", "is cable, expected stockinette", 1, 30},
      {"negative_radius", good_scene(R"(, "yarn": {"radius_m": -0.001})"), "yarn.radius_m", "is -0.001, expected", 6,
       52},
      {"negative_step", good_scene(R"(, "fixed": {"time_step_s": -1})"), "fixed.time_step_s", "is -1, expected", 6, 56},
      {"accuracy", good_scene(R"(, "accuracy": {"tolerance_m": 0})"), "accuracy.tolerance_m", "is 0, expected", 6, 59},
      {"budget", good_scene(R"(, "accuracy": {"budget_s": -2})"), "accuracy.budget_s",
       "is -2, expected a finite number > 0", 6, 56},
      {"tolerance_and_budget", good_scene(R"(, "accuracy": {"tolerance_m": 1e-4, "budget_s": 60})"),
       "accuracy.budget_s", "is a second choice beside \"tolerance_m\", expected only one of them", 6, 65},
      {"neither_tolerance_nor_budget", good_scene(R"(, "accuracy": {})"), "accuracy",
       "is empty, expected either tolerance_m or budget_s", 6, 43},
      {"needs_sliding",
       good_scene(R"(, "name": "x")").replace(good_scene().find("\"stretch\""), 9, "\"sliding_friction\""),
       "effects.sliding_friction", "sliding", 6, 35},
      {"dynamic_box", with_collider(R"({"box": {"half_size_m": [1, 1, 1]}, "dynamic": {"mass_kg": 1}})"),
       "effects.colliders.colliders[0].dynamic", "is given for a box, expected none: only a sphere can be dynamic", 7,
       48},
      {"dynamic_without_mass", with_collider(R"({"sphere": {"radius_m": 1}, "dynamic": {}})"),
       "effects.colliders.colliders[0].dynamic.mass_kg", "is 0, expected a finite number > 0", 7, 40},
      {"dynamic_by_script",
       with_collider(R"({"sphere": {"radius_m": 1}, "motion": [{"t": 1}], "dynamic": {"mass_kg": 1}})"),
       "effects.colliders.colliders[0].dynamic", "is given, expected either motion or dynamic, not both", 7, 62},
      {"dynamic_at_rest", with_collider(R"({"sphere": {"radius_m": 1}, "dynamic": {"mass_kg": 1}})", ""),
       "effects.colliders.colliders[0].dynamic", "is given, expected effects.inertia listed too", 7, 40},
      {"handle_outside", good_scene(R"(, "handles": [{"where": {"stitches": {"last_course": 3}}}])"),
       "handles[0].where.stitches.last_course", "is 3, expected 1 to 2", 6, 82},
      {"too_many_stitches", R"({"knit": {"preset": {"name": "stockinette", "courses": 30000, "wales": 30000},
        "gauge": {"yarn_per_stitch_m": 0.011}}})",
       "knit.preset", "at most 250000 stitches", 1, 21, true},
      {"too_many_frames", good_scene(R"(, "duration_s": 1e6, "frames_per_s": 1e3)"), "frames_per_s", "expected", 6, 66,
       true},
  };
}

class BadInputTest : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, IsRefusedWithPathValueAndPlace) {
  const BadInput& bad = GetParam();
  LoadResult result = load_scene_json(bad.text);
  ASSERT_TRUE(std::holds_alternative<Issues>(result));
  const Issues& issues = std::get<Issues>(result);
  auto found = std::find_if(issues.begin(), issues.end(), [&](const Issue& issue) {
    return issue.path == bad.path && issue_line(issue).find(bad.fragment) != std::string::npos;
  });
  ASSERT_NE(found, issues.end()) << issue_lines(issues);
  EXPECT_EQ(found->too_big, bad.too_big);
  EXPECT_EQ(found->line, bad.line) << issue_lines(issues);
  EXPECT_EQ(found->column, bad.column) << issue_lines(issues);
  EXPECT_EQ(issues.size(), 1u) << issue_lines(issues);
}

INSTANTIATE_TEST_SUITE_P(Table, BadInputTest, testing::ValuesIn(bad_inputs()),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(BadInput, GoodSceneOfTheTableLoads) { EXPECT_EQ(problems(load_scene_json(good_scene())), ""); }

TEST(BadInput, AllProblemsComeAtOnce) {
  std::string text = good_scene(R"(, "durationS": 2, "yarn": {"radius_m": "x", "stretch_n": -1}, "name": null)");
  LoadResult result = load_scene_json(text);
  std::vector<std::string> paths;
  for (const Issue& issue : std::get<Issues>(result)) paths.push_back(issue.path);
  std::sort(paths.begin(), paths.end());
  EXPECT_EQ(paths, (std::vector<std::string>{"durationS", "name", "yarn.radius_m", "yarn.stretch_n"}))
      << problems(result);
}

TEST(BadInput, ListOfProblemsIsBounded) {
  std::string text = R"({"yarns": [{"points_m": [)";
  for (int i = 0; i < 1000; ++i) text += "null, ";
  LoadResult result = load_scene_json(text + "1]}]}");
  const Issues& issues = std::get<Issues>(result);
  EXPECT_EQ(issues.size(), kMaxIssues + 1);
  EXPECT_NE(issue_lines(issues).find("the rest is not listed"), std::string::npos);
}

TEST(BadInput, NoNumberOfProblemsMakesALongList) {
  const auto many = [](const std::string& before, const std::string& part, const std::string& after) {
    std::string text = before;
    for (int i = 0; i < 100'000; ++i) text += part;
    return text + after;
  };
  for (const std::string& text :
       {many("{", R"("name":"a",)", R"("yarns":[]})"), many("{", R"("nam":1,)", R"("yarns":[]})"),
        many(R"({"guides":[)", "1,", "1]}"), many(R"({"handles":[)", "{},", "{}]}"),
        many(R"({"knit":{"chart":{"rows":[)", R"("X",)", R"("Z"]}}})"),
        many(R"({"knit":{"worked_rows":{"rows":[")", "X", R"("]}}})"),
        many(R"({"effects":{"colliders":{"colliders":[)", R"({"dynamic":{"velocity_m_per_s":[1]}},)", "{}]}}}"),
        many(R"({"handles":[{"motion":[)", R"({"rotation_rad":[1]},)", "{}]}]}")}) {
    const LoadResult result = load_scene_json(text);
    const Issues& issues = std::get<Issues>(result);
    EXPECT_EQ(issues.size(), kMaxIssues + 1) << text.substr(0, 60) << "\n" << issue_line(issues.front());
    EXPECT_TRUE(issues.full());
  }
}

TEST(BadInput, ProblemsOfLongTextsAreShort) {
  const std::string x(1 << 20, 'x');
  for (const std::string& text :
       {with_rows("\"" + x + "\""), R"({"name":)" + x + "}", R"({"name":")" + x, R"({")" + x + R"(":1})",
        R"({"duration_s":")" + x + R"("})", R"({"handles":[{"where":{"edge":")" + x + R"("}}]})",
        R"({"knit":{"preset":{"name":")" + x + R"(","courses":2,"wales":2}}})"}) {
    const LoadResult result = load_scene_json(text);
    for (const Issue& issue : std::get<Issues>(result)) {
      EXPECT_LT(issue_line(issue).size(), 1500U) << issue_line(issue).substr(0, 300);
    }
  }
}

TEST(BadInput, SizesOfChartsComeBeforeLetters) {
  for (const char* kind : {"chart", "worked_rows"}) {
    const std::string rows = "[\"" + std::string(200'000, 'X') + "\",\"" + std::string(50'001, 'Z') + "\"]";
    const LoadResult result = load_scene_json(std::string(R"({"knit":{")") + kind + R"(":{"rows":)" + rows +
                                              R"(},"gauge":{"yarn_per_stitch_m":0.01}}})");
    const Issues& issues = std::get<Issues>(result);
    ASSERT_EQ(issues.size(), 1U) << issue_lines(issues);
    EXPECT_TRUE(issues.front().too_big);
    EXPECT_EQ(issues.front().path, std::string("knit.") + kind + ".rows");
    EXPECT_EQ(issues.front().value, "250001 stitches");
    EXPECT_EQ(issues.front().limit, 250'000);
  }
}

// Places of many problems are found in one reading of the text, in any order.
TEST(BadInput, PlacesAreFoundInAnyOrder) {
  const std::string text = "a\n\xc3\xa9\xc3\xa9 b\nc";
  PlaceFinder places(text);
  for (const std::size_t offset : {7U, 2U, 8U, 8U, 0U, 100U}) {
    const TextPlace place = places.of(offset), alone = place_of(text, offset);
    EXPECT_EQ(place.line, alone.line) << offset;
    EXPECT_EQ(place.column, alone.column) << offset;
  }
  EXPECT_EQ(places.of(7).line, 2);
  EXPECT_EQ(places.of(7).column, 4);
  EXPECT_EQ(places.of(kNoOffset).line, 0);
}

TEST(BadInput, ValuesOfProblemsAreUtf8) {
  LoadResult result = load_scene_json(with_rows("[\"K\xc3\xa9K\", \"KKKK\"]"));
  std::string text = problems(result);
  EXPECT_NE(text.find("\xef\xbf\xbd in column 2"), std::string::npos) << text;
}

TEST(BadInput, MessagesAreCheckedLikeFiles) {
  v1::Scene message = std::get<LoadedScene>(load_scene_json(good_scene())).message;
  EXPECT_EQ(problems(load_scene_message(message)), "");
  message.mutable_yarn()->set_radius_m(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(problems(load_scene_message(message)).find("yarn.radius_m: is nan"), std::string::npos)
      << problems(load_scene_message(message));
}

TEST(BadInput, UnknownFieldNumbersAreRefused) {
  v1::Scene message = std::get<LoadedScene>(load_scene_json(good_scene())).message;
  v1::Knit& knit = *message.mutable_knit();
  knit.GetReflection()->MutableUnknownFields(&knit)->AddVarint(999, 1);
  EXPECT_NE(problems(load_scene_message(message)).find("knit: is unknown field number 999"), std::string::npos);
}

TEST(BadInput, UnknownEnumNumbersAreRefused) {
  v1::Scene message = std::get<LoadedScene>(load_scene_json(good_scene())).message;
  message.add_handles()->mutable_where()->set_corner(static_cast<v1::Selector::Corner>(77));
  EXPECT_NE(problems(load_scene_message(message)).find("handles[0].where.corner: is 77"), std::string::npos);
}

TEST(SceneFile, AByteOrderMarkIsNoPartOfIt) {
  const test::TemporaryFolder folder;
  const std::string mark = "\xef\xbb\xbf";
  test::write_bytes(folder / "good.json", mark + good_scene());
  test::write_bytes(folder / "chart.txt", mark + "KPK\nKKK\n");
  test::write_bytes(folder / "bad.json", mark + R"({"duration_s": -1})");
  test::write_bytes(folder / "bad.txt", mark + "KXK\nKKK\n");
  EXPECT_EQ(problems(load_scene_file(folder / "good.json")), "");
  EXPECT_EQ(problems(load_scene_file(folder / "chart.txt")), "");
  EXPECT_NE(problems(load_scene_file(folder / "bad.json"))
                .find("duration_s: is -1, expected a finite number >= 0 (line 1, column 16)"),
            std::string::npos)
      << problems(load_scene_file(folder / "bad.json"));
  EXPECT_EQ(problems(load_scene_file(folder / "bad.txt")),
            "knit.chart.rows[0]: is X in column 2, expected K or P (line 1)\n");
}

TEST(BadInput, FilesThatAreNoScenes) {
  auto problem = [](const char* path) { return problems(load_scene_file(path)); };
  EXPECT_NE(problem("/nonexistent/scene.json").find("a file that can be read"), std::string::npos);
  EXPECT_NE(problem("/").find("a .json scene or a .txt chart"), std::string::npos);
  for (const char* path : {"a.k", "a.csv", "a.png"}) {
    EXPECT_NE(problem(path).find("not supported yet"), std::string::npos) << path;
  }
}

}  // namespace
}  // namespace slipstitch
