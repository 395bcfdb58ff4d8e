// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "formats/formats.h"
#include "scene_io/load_scene.h"

namespace slipstitch {

/// Options that several commands share, and what is said when they are wrong. All messages go to stderr.

void complain(const std::string& message);  // "slipstitch: message"
void note(const std::string& message);

struct SceneOptions {
  std::string scene;
  Settings settings;
};
void add_scene_options(CLI::App& app, SceneOptions& options);
void add_settings_option(CLI::App& app, Settings& settings);
std::optional<LoadedScene> load(const SceneOptions& options);

void add_threads_option(CLI::App& app, int& threads);
void add_json_flag(CLI::App& app, bool& json);
void add_server_option(CLI::App& app, std::string& server);
void add_job_argument(CLI::App& app, std::string& job);

/// Where frames go and which.
struct FrameFileOptions {
  std::string out, format;
  int first = 0, stride = 1;
  bool force = false;
};
void add_frame_file_options(CLI::App& app, FrameFileOptions& options);
const Format* known_format(const FrameFileOptions& options);

/// A folder that is not empty, unless forced; says so.
bool refuse_occupied(const std::string& folder, bool force);

/// An argument as a shell takes it.
std::string shell_word(const std::string& text);

}  // namespace slipstitch
