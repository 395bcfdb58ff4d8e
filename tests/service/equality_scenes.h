// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "support/sample_run.h"

namespace slipstitch::test {

using nlohmann::json;

inline json small_knit() { return json::parse(read_bytes(SLIPSTITCH_SOURCE_DIR "/scenes/small-swing.json")); }

inline json yarn_point(int yarn, int point) {
  return {{"where", {{"yarn_point", {{"yarn", yarn}, {"point", point}}}}}};
}

// The small knit, and two bare yarns: the second hangs over the first and is pulled over it. A sphere falls on them.
inline json sliding_scene() {
  json scene = small_knit();
  scene["duration_s"] = 0.1;
  scene["yarns"] = {{{"points_m", {-0.04, 0, 0.02, -0.02, 0, 0.02, 0, 0, 0.02, 0.02, 0, 0.02, 0.04, 0, 0.02}}},
                    {{"points_m", {0, -0.016, 0.032, 0, 0, 0.02, 0, -0.02, 0.02, 0, -0.04, 0.02, 0, -0.06, 0.02}}}};
  scene["crossings"] = {{{"yarn_a", 0}, {"point_a", 2}, {"yarn_b", 1}, {"point_b", 1}}};
  scene["handles"].push_back(yarn_point(0, 0));
  scene["handles"].push_back(yarn_point(0, -1));
  scene["loads"].push_back(yarn_point(1, -1));
  scene["loads"][0]["force_n"] = {0, -0.03, 0};
  scene["effects"]["colliders"]["colliders"] = {
      {{"sphere", {{"centre_m", {0.01, 0.005, 0.03}}, {"radius_m", 0.005}}},
       {"dynamic", {{"mass_kg", 1e-4}, {"velocity_m_per_s", {0, -0.1, -0.3}}}}}};
  return scene;
}

// A knit and a bare yarn, thrown; effects without sliding keep its one step cheap.
inline json wide_scene() {
  json scene = small_knit();
  scene.erase("handles");
  scene["knit"]["preset"] = {{"name", "stockinette"}, {"courses", 84}, {"wales", 84}};
  scene["yarns"] = {{{"points_m", {0.1, 0, 0.02, 0.11, 0.01, 0.02, 0.12, 0, 0.02}}}};
  scene["effects"] = {{"inertia", json::object()}, {"gravity", json::object()}, {"stretch", json::object()}};
  scene["initial_velocities"] = {{{"where", {{"all", json::object()}}}, {"velocity_m_per_s", {0.1, 0.2, 0.3}}}};
  scene["duration_s"] = 0.01;
  scene["frames_per_s"] = 100;
  scene["fixed"]["time_step_s"] = 0.01;
  return scene;
}

}  // namespace slipstitch::test
