// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "gauntlet/dice.h"
#include "model/model.h"

namespace slipstitch::gauntlet {

/// A random scene that is being made. Lengths go by the yarn's radius and ways by the radius a step, so that every size
/// of yarn and every step has the same troubles.
struct Draft {
  explicit Draft(std::uint64_t seed) : dice(seed) {}

  Dice dice;
  Scene scene;
  int steps = 0;        // that the run takes if none is cut
  double step_s = 0.0;  // of each
  std::string about;    // what was drawn, in words

  double radius() const { return scene.yarn.radius_m; }
  double duration_s() const { return steps * step_s; }
  double radius_a_step() const { return radius() / step_s; }  // [m/s]
  bool moves() const { return scene.effects.inertia.has_value(); }
  void say(const std::string& what) { about += (about.empty() ? "" : ", ") + what; }
};

// In the order in which they are called.
void draw_times(Draft& draft);
void draw_material(Draft& draft);
void draw_fabric(Draft& draft);   // a knit, bare yarns or both
void draw_effects(Draft& draft);  // but colliders

// Those that see the model of what the scene has so far.
void draw_scripts(Draft& draft, const Model& model);  // handles, loads, initial velocities
void draw_colliders(Draft& draft, const Model& model);
void keep_scripts_clear(Draft& draft, Model model);  // takes scripts away that would press held yarn into a collider

}  // namespace slipstitch::gauntlet
