// SPDX-License-Identifier: MIT
#include "scene_io/load_scene.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "scene_io/chart_text.h"
#include "scene_io/convert.h"
#include "scene_io/json_parse.h"
#include "scene_io/json_set.h"
#include "scene_io/message_json.h"
#include "scene_io/read_message.h"

namespace slipstitch {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // editors on Windows put it in front of UTF-8

/// True when the problem at `earlier` may be the only cause of one reported at `later`: the same field or one that
/// holds it. After a problem of the whole document nothing else can be told.
bool may_cause(const std::string& earlier, const std::string& later) {
  if (earlier.empty() || earlier == later) return true;
  return !later.empty() && earlier.starts_with(later) && (earlier[later.size()] == '.' || earlier[later.size()] == '[');
}

/// Leaves out what another problem may have caused. `knit_is_broken`: no pattern, so nothing can select stitches.
void add_independent(const Issues& more, bool knit_is_broken, Issues& issues) {
  const Issues before = issues;
  for (const Issue& issue : more) {
    auto causes = [&](const Issue& earlier) { return may_cause(earlier.path, issue.path); };
    if (std::any_of(before.begin(), before.end(), causes)) continue;
    bool selects = issue.path.starts_with("handles[") || issue.path.starts_with("loads[") ||
                   issue.path.starts_with("initial_velocities[");
    if (knit_is_broken && selects) continue;
    issues.push_back(issue);
  }
}

Issues presentable(Issues issues) {
  for (Issue& issue : issues) issue.value = valid_utf8(issue.value);
  return issues;
}

/// Converts and checks. `issues`: problems found before.
LoadResult load(const v1::Scene& message, const SceneLimits& limits, Issues issues) {
  Issues conversion;
  LoadedScene loaded;
  loaded.scene = scene_from_message(message, conversion, limits);
  add_independent(conversion, false, issues);
  bool knit_is_broken = loaded.scene.knit && loaded.scene.knit->pattern.cells.empty();
  if (knit_is_broken && issues.empty()) issues.push_back({"knit", "empty", "a pattern"});
  add_independent(check(loaded.scene, limits), knit_is_broken, issues);
  if (!issues.empty()) return presentable(std::move(issues));
  loaded.message = message_from_scene(loaded.scene);
  return loaded;
}

LoadResult load_document(JsonNode root, std::string_view text, const Settings& settings, const SceneLimits& limits,
                         Issues issues) {
  for (const std::string& setting : settings) apply_setting(root, setting, issues);
  v1::Scene message;
  read_message(root, text, message, issues);
  LoadResult result = load(message, limits, std::move(issues));
  if (auto* found = std::get_if<Issues>(&result)) {
    PlaceFinder places(text);
    for (Issue& issue : *found) {
      if (issue.line > 0 || issue.path.empty()) continue;
      const TextPlace place = places.of(nearest_node(root, issue.path).offset);
      issue.line = place.line;
      issue.column = place.column;
    }
  }
  return result;
}

std::optional<std::string> file_text(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream read;
  read << file.rdbuf();  // iterators of the buffer would throw what cannot be read
  if (!file.is_open() || read.bad()) return std::nullopt;
  std::string text = read.str();
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

/// Problems of rows are shown where the rows stand in the chart file, all others without a place.
void place_in_chart(const ChartText& chart, Issues& issues) {
  for (Issue& issue : issues) {
    issue.line = issue.column = 0;
    for (std::size_t row = 0; row < chart.lines.size(); ++row) {
      if (issue.path == "knit.chart.rows[" + std::to_string(row) + "]") issue.line = chart.lines[row];
    }
  }
}

}  // namespace

Issues with_independent(Issues first, const Issues& more) {
  add_independent(more, false, first);
  return first;
}

LoadResult load_scene_json(std::string_view text, const Settings& settings, const SceneLimits& limits) {
  Issues issues;
  std::optional<JsonNode> root = parse_json(text, issues);
  if (!root) return presentable(std::move(issues));
  return load_document(std::move(*root), text, settings, limits, std::move(issues));
}

LoadResult load_scene_chart(std::string_view text, const std::string& name, const Settings& settings,
                            const SceneLimits& limits) {
  ChartText chart = split_chart(text);
  LoadResult result = load_scene_json(json_text(scene_for_chart(chart.rows, name)), settings, limits);
  if (auto* issues = std::get_if<Issues>(&result)) place_in_chart(chart, *issues);
  return result;
}

LoadResult load_scene_message(const v1::Scene& message, const SceneLimits& limits) {
  Issues issues;
  find_unknown_fields(message, "", issues);
  return load(message, limits, std::move(issues));
}

LoadResult load_scene_file(const std::filesystem::path& path, const Settings& settings, const SceneLimits& limits) {
  const std::string extension = path.extension().string();
  if (extension == ".k" || extension == ".csv" || extension == ".png") {
    return Issues{
        {"", "\"" + path.string() + "\"", "a .json scene or a .txt chart; " + extension + " is not supported yet"}};
  }
  if (extension != ".json" && extension != ".txt") {
    return Issues{{"", "\"" + path.string() + "\"", "a .json scene or a .txt chart"}};
  }
  std::optional<std::string> text = file_text(path);
  if (!text) return Issues{{"", "\"" + path.string() + "\"", "a file that can be read"}};
  if (extension == ".txt") return load_scene_chart(*text, path.stem().string(), settings, limits);
  return load_scene_json(*text, settings, limits);
}

}  // namespace slipstitch
