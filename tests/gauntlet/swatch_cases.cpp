// SPDX-License-Identifier: MIT
// Swatches that are stretched, pressed, twisted and shaken.
#include <cmath>

#include "gauntlet/case_parts.h"

namespace slipstitch::gauntlet {
namespace {

GauntletCase stretched_and_released() {
  GauntletCase item = named("stretched-300-released", "three times as wide at the start, and let go", swatch(6, 6));
  item.change = placed([](const Vec3& x) { return Vec3(3.0 * x.x(), x.y(), x.z()); });
  item.limits.max_stretch = 4.5;
  item.limits.isolated = true;
  item.about_motion = true;
  item.limits.max_ridge_entries = 5;
  item.limits.max_crushed_entries = 300;  // where it is a thousand times softer
  return item;
}

GauntletCase stretched() {
  GauntletCase item = named("stretched-150", "drawn to one and a half of its width", swatch(6, 6));
  item.scene.handles = {pin(Edge::left), Handle{Edge::right, {{0.2, {6e-3, 0, 0}, Vec3::Zero()}}}};
  return item;
}

/// Twelve wales, 24.6 mm wide at rest, whose right edge comes nearer: six would leave no room for two layers of a fold.
GauntletCase pressed(const char* name, const char* about, double way) {
  GauntletCase item = named(name, about, swatch(5, 12));
  item.scene.effects.self_collision.emplace();
  item.scene.handles = {pin(Edge::left), Handle{Edge::right, {{0.4, {-way, 0, 0}, Vec3::Zero()}}}};
  item.scene.duration_s = 0.4;
  item.limits.max_stretch = 4.0;
  item.limits.max_ridge_entries = 50;
  item.limits.max_crushed_entries = 10;
  return item;
}

GauntletCase compressed() {
  return pressed("compressed-30", "pressed between two edges to three tenths of its width", 17.2e-3);
}

/// Down to 0.7 mm between what is held, less than a diameter of yarn.
GauntletCase pressed_shut() {
  GauntletCase item = pressed("pressed-shut", "pressed until its edges meet", 20.3e-3);
  item.limits.impossible = true;  // yarn that is caught between the edges has no room
  return item;
}

GauntletCase twisted() {
  GauntletCase item = named("twisted-five-turns", "a ribbon whose upper edge makes five turns", swatch(14, 4));
  item.scene.effects.self_collision.emplace();
  item.scene.handles = {pin(Edge::bottom), Handle{Edge::top, {{1.0, Vec3::Zero(), {0, 10.0 * kPi, 0}}}}};
  item.scene.duration_s = 1.0;
  item.limits.max_newton = 9000;
  item.limits.max_ridge_entries = 150;
  item.limits.max_fade_entries = 100;
  item.limits.max_crushed_entries = 10;
  return item;
}

GauntletCase shaken() {
  GauntletCase item = named("shaken-50-hz", "held along its upper edge, which shakes at 50 Hz by 2 mm", swatch(6, 6));
  item.scene.effects.gravity.emplace();
  item.scene.handles = {pin(Edge::top)};
  for (int k = 1; k <= 80; ++k)
    item.scene.handles[0].motion.push_back({k / 400.0, {0, 0, 2e-3 * std::sin(k * kPi / 4.0)}, Vec3::Zero()});
  item.about_motion = true;
  return item;
}

GauntletCase noise() {
  GauntletCase item =
      named("noise-of-half-a-stitch", "every node begins up to half a stitch from its place", swatch(6, 6));
  item.scene.knit->noise_m = 1e-3;
  item.limits.max_stretch = 12.0;
  item.limits.isolated = true;
  item.limits.max_ridge_entries = 20;
  item.limits.max_fade_entries = 80;
  item.limits.max_crushed_entries = 100;
  return item;
}

GauntletCase inside_out() {
  GauntletCase item = named("folded-inside-out", "begins folded in half, its right side inside", swatch(8, 6));
  const double middle = 4 * 2.03e-3;
  item.change =
      placed([middle](const Vec3& x) { return x.y() <= middle ? x : Vec3(x.x(), 2.0 * middle - x.y(), x.z() + 6e-3); });
  item.limits.max_stretch = 12.0;
  item.limits.max_crushed_entries = 100;
  item.limits.isolated = true;
  return item;
}

/// The relaxed swatch as it lies, nudged.
GauntletCase rest() {
  GauntletCase item =
      named("kicked-rest", "a relaxed swatch after a kick of a thousandth of the radius a step", swatch(5, 5));
  item.scene.initial_velocities = {{Corner::top_left, {0, 0, 1e-3 * 0.524e-3 * 240}}};
  item.limits.isolated = true;
  return item;
}

GauntletCase creeping() {
  GauntletCase item = named("creeping", "a heavy load that stiff sliding friction lets down slowly", swatch(5, 5));
  hang(item.scene);
  item.scene.effects.damping->sliding_ns_per_m = 1e4;
  item.scene.loads = {{Edge::bottom, {0, -0.05, 0}}};
  return item;
}

}  // namespace

std::vector<GauntletCase> swatch_cases() {
  return {stretched_and_released(),
          stretched(),
          compressed(),
          pressed_shut(),
          twisted(),
          shaken(),
          noise(),
          inside_out(),
          rest(),
          creeping()};
}

}  // namespace slipstitch::gauntlet
