// SPDX-License-Identifier: MIT
#include "prediction/calibration_cache.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "platform/blas.h"
#include "platform/version.h"
#include "prediction/cpu_name.h"
#include "run_dir/atomic_file.h"

namespace slipstitch {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBytes = 1 << 20;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

fs::path file_of(const fs::path& folder, std::string key) {
  for (char& c : key)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.') c = '-';
  return folder / ("calibration-" + key + ".json");
}

Json course_json(const RunCourse& course) {
  Json json = Json::array();
  for (const RunPoint& point : course) json.push_back({point.t, point.steps, point.iterations});
  return json;
}

// Throws what nlohmann::json throws of values of other kinds, or that are not there.
RunCourse course_of(const nlohmann::json& json) {
  RunCourse course;
  for (const auto& point : json)
    course.push_back({point.at(0).get<double>(), point.at(1).get<double>(), point.at(2).get<double>()});
  return course;
}

Calibration calibration_of(const nlohmann::json& json) {
  const auto& cost = json.at("cost");
  const auto& sheet = json.at("sheet");
  return {{cost.at("per_nonzero_s").get<double>(), cost.at("per_operation_s").get<double>()},
          {static_cast<int>(std::clamp(sheet.at("dofs").get<double>(), 0.0, 1e9)),
           sheet.at("nonzeros").get<double>(),
           {sheet.at("factor_entries").get<double>(), sheet.at("factor_operations").get<double>()}},
          course_of(json.at("fixed")),
          course_of(json.at("accurate"))};
}

}  // namespace

fs::path default_cache_folder() {
  if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return fs::path(cache) / "slipstitch";
  if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache/slipstitch";
  return {};
}

std::string calibration_key() { return version_string() + " " + blas_in_use().kernel + " " + cpu_name(); }

std::string calibration_json(const Calibration& calibration, const std::string& key) {
  const IterationCost& cost = calibration.cost;
  const ProblemSize& sheet = calibration.sheet;
  const Json json{{"key", key},
                  {"cost", {{"per_nonzero_s", cost.per_nonzero_s}, {"per_operation_s", cost.per_operation_s}}},
                  {"sheet",
                   {{"dofs", sheet.dofs},
                    {"nonzeros", sheet.nonzeros},
                    {"factor_entries", sheet.factor.entries},
                    {"factor_operations", sheet.factor.operations}}},
                  {"fixed", course_json(calibration.fixed)},
                  {"accurate", course_json(calibration.accurate)}};
  return json.dump(1) + "\n";
}

std::optional<Calibration> calibration_from_json(std::string_view text, const std::string& key) {
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    if (json.at("key") != key) return std::nullopt;
    Calibration calibration = calibration_of(json);
    return is_sound(calibration) ? std::optional(std::move(calibration)) : std::nullopt;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

Calibration kept_calibration(const fs::path& folder, const std::string& key,
                             const std::function<Calibration()>& calibrate) {
  if (folder.empty()) return calibrate();
  const fs::path file = file_of(folder, key);
  if (const Result<std::string> text = read_file(file, kMostBytes))
    if (const auto kept = calibration_from_json(*text, key)) return *kept;
  Calibration made = calibrate();
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && is_sound(made))
    (void)write_file_atomic(file, calibration_json(made, key));  // else the next one makes it
  return made;
}

const Calibration& machine_calibration() {
  static const Calibration calibration =
      kept_calibration(default_cache_folder(), calibration_key(), [] { return calibrate(steady_clock_s); });
  return calibration;
}

}  // namespace slipstitch
