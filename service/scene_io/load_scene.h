// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "model/scene.h"
#include "slipstitch/v1/scene.pb.h"

namespace slipstitch {

/// A scene that can run. `message` is the same scene with every default written out.
struct LoadedScene {
  Scene scene;
  v1::Scene message;
};

/// The scene, or every problem found (never empty).
using LoadResult = std::variant<LoadedScene, Issues>;

/// "yarn.radius_m=0.0005", "handles[0].where.corner=TOP_LEFT": applied in order to the JSON document before it is read.
/// Missing objects are made. The value is JSON, or else a string.
using Settings = std::vector<std::string>;

/// Reads a scene file (.json) or a chart (.txt, run with the defaults of chart_text.h) and checks it. UTF-8, with or
/// without a byte order mark.
LoadResult load_scene_file(const std::filesystem::path& path, const Settings& settings = {},
                           const SceneLimits& limits = {});

LoadResult load_scene_json(std::string_view text, const Settings& settings = {}, const SceneLimits& limits = {});

LoadResult load_scene_chart(std::string_view text, const std::string& name, const Settings& settings = {},
                            const SceneLimits& limits = {});

/// For a scene that came as a message: unknown fields, what convert.h finds, then check().
LoadResult load_scene_message(const v1::Scene& message, const SceneLimits& limits = {});

/// `first`, then those of `more` that no problem of `first` may have caused: one of the same field or of a part of it.
Issues with_independent(Issues first, const Issues& more);

}  // namespace slipstitch
