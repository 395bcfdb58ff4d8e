// SPDX-License-Identifier: MIT
#pragma once

#include <google/protobuf/util/message_differencer.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "scene_io/issue_text.h"
#include "scene_io/load_scene.h"

namespace slipstitch {

/// A scene that loads, as text with marked places for what a test puts in.
inline std::string good_scene(const std::string& more = "") {
  return R"({
  "knit": {
    "chart": {"rows": ["KP", "PK"]},
    "gauge": {"course_spacing_m": 0.0029, "wale_spacing_m": 0.00203}
  },
  "effects": {"stretch": {}})" +
         more + "\n}\n";
}

inline std::string file_content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::vector<std::filesystem::path> scene_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SLIPSTITCH_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  return files;
}

inline std::string problems(const LoadResult& result) {
  const auto* issues = std::get_if<Issues>(&result);
  return issues == nullptr ? "" : issue_lines(*issues);
}

inline std::string difference(const google::protobuf::Message& a, const google::protobuf::Message& b) {
  google::protobuf::util::MessageDifferencer differencer;
  std::string report;
  differencer.ReportDifferencesToString(&report);
  return differencer.Compare(a, b) ? "" : report;
}

}  // namespace slipstitch
