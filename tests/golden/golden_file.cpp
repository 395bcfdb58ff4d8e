// SPDX-License-Identifier: MIT
#include "golden_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace slipstitch::golden {

Json load_cases(const std::string& file_name) {
  const char* folder = std::getenv("SLIPSTITCH_GOLDEN_DIR");
  const std::filesystem::path path =
      std::filesystem::path(folder ? folder : SLIPSTITCH_SOURCE_DIR "/tests/data") / file_name;
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  Json cases = Json::parse(file).at("cases");
  if (!cases.is_array() || cases.empty()) throw std::runtime_error("no cases in " + path.string());
  return cases;
}

Json cases_of_term(const std::string& term) {
  Json selected = Json::array();
  for (const Json& c : load_cases("terms_golden.json")) {
    if (c.at("term") == term) selected.push_back(c);
  }
  if (selected.empty()) throw std::runtime_error("no case of term " + term);
  return selected;
}

void expect_categories(const Json& cases, const std::vector<std::string>& categories) {
  for (const std::string& category : categories) {
    int count = 0;
    for (const Json& c : cases) count += c.at("category") == category;
    EXPECT_GT(count, 0) << "no case of category " << category;
  }
}

}  // namespace slipstitch::golden
