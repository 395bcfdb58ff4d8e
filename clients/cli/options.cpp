// SPDX-License-Identifier: MIT
#include "cli/options.h"

#include <filesystem>
#include <iostream>

#include "cli/screen/text.h"
#include "run_dir/run_dir.h"
#include "scene_io/issue_text.h"

namespace slipstitch {
namespace fs = std::filesystem;
namespace {

std::string format_names() {
  std::string names;
  for (const Format& format : formats()) names += (names.empty() ? "" : ", ") + std::string(format.name);
  return names;
}

// Without the range in the help, where it would only fill the line.
CLI::Validator in_range(int first, int last) { return CLI::Range(first, last).description(""); }

bool can_be_read(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    complain("there is no file '" + path + "'");
  } else if (fs::is_directory(status)) {
    complain("'" + path + "' is a folder; expected a .json scene or a .txt chart");
  } else {
    return true;
  }
  return false;
}

}  // namespace

void complain(const std::string& message) { std::cerr << "slipstitch: " << message << std::endl; }

void note(const std::string& message) { std::cerr << message << std::endl; }

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("SCENE", options.scene, "A scene (.json), or a chart of K and P rows (.txt)")
      ->type_name("")
      ->required();
  add_settings_option(app, options.settings);
}

void add_settings_option(CLI::App& app, Settings& settings) {
  app.add_option("--set", settings, "Change the scene first, e.g. yarn.radius_m=0.6e-3")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::optional<LoadedScene> load(const SceneOptions& options) {
  if (!can_be_read(options.scene)) return std::nullopt;
  LoadResult result = load_scene_file(options.scene, options.settings);
  if (auto* scene = std::get_if<LoadedScene>(&result)) return std::move(*scene);
  const auto& issues = std::get<Issues>(result);
  complain("'" + options.scene + "' cannot be run; " +
           count_of(static_cast<long>(issues.size()), "problem:", "problems:"));
  std::cerr << issue_lines(issues) << std::flush;
  return std::nullopt;
}

void add_threads_option(CLI::App& app, int& threads) {
  app.add_option("--threads", threads, "Threads of the solver's dense blocks; default: 1")
      ->type_name("N")
      ->check(in_range(1, 1024));
}

void add_json_flag(CLI::App& app, bool& json) {
  app.add_flag("--json", json, "Print one JSON object to stdout, nothing else");
}

void add_server_option(CLI::App& app, std::string& server) {
  app.add_option("--server", server, "Default: SLIPSTITCH_SERVER, else 127.0.0.1:50651")->type_name("HOST:PORT");
}

void add_job_argument(CLI::App& app, std::string& job) {
  app.add_option("JOB", job, "Name of a job: simJobs/ID, or its ID")->type_name("")->required();
}

void add_frame_file_options(CLI::App& app, FrameFileOptions& options) {
  app.add_option("--out", options.out, "Folder for the files, new or empty")->type_name("DIR")->required();
  app.add_option("--format", options.format, "Kind of file: " + format_names())->type_name("F")->required();
  app.add_option("--first", options.first, "Index of the first frame, default 0")
      ->type_name("N")
      ->check(in_range(0, 1'000'000'000));
  app.add_option("--stride", options.stride, "Every K-th frame from there, default 1")
      ->type_name("K")
      ->check(in_range(1, 1'000'000'000));
  app.add_flag("--force", options.force, "Take a folder that is not empty");
}

const Format* known_format(const FrameFileOptions& options) {
  const Format* format = find_format(options.format);
  if (format == nullptr) complain(format_error(options.format));
  return format;
}

bool refuse_occupied(const std::string& folder, bool force) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    complain("'" + folder + "' exists and is not a folder");
    return true;
  }
  if (force || !occupied(folder)) return false;
  complain("'" + folder + "' is not empty; choose another folder, or --force to write into it");
  return true;
}

std::string shell_word(const std::string& text) {
  constexpr char kPlain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./:=+,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace slipstitch
