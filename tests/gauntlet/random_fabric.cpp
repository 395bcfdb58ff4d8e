// SPDX-License-Identifier: MIT
// Yarn, charts and bare yarns of random scenes.
#include <array>

#include "gauntlet/random_parts.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kUsualRadius = YarnMaterial{}.radius_m;
// Of the default gauge.
constexpr double kCourseSpacing = 2.9e-3 / kUsualRadius, kWaleSpacing = 2.03e-3 / kUsualRadius;

/// A motif of up to 3x3 stitches that repeats, or a chart without any repeat.
Pattern irregular(Dice& dice, int courses, int wales, bool in_the_round) {
  const bool repeats = dice.chance(0.7);
  const int high = repeats ? dice.between(1, 3) : courses, wide = repeats ? dice.between(1, 3) : wales;
  std::vector<std::string> motif(static_cast<std::size_t>(high));
  for (std::string& row : motif)
    for (int w = 0; w < wide; ++w) row += dice.chance(0.5) ? 'K' : 'P';
  std::vector<std::string> rows;
  for (int c = 0; c < courses; ++c) {
    std::string& row = rows.emplace_back();
    for (int w = 0; w < wales; ++w)
      row += motif[static_cast<std::size_t>(c % high)][static_cast<std::size_t>(w % wide)];
  }
  Issues none;
  const bool worked = dice.chance(0.3);
  return worked ? pattern_from_worked_rows(rows, in_the_round, "rows", none)
                : pattern_from_chart(rows, in_the_round, "rows", none);
}

Pattern random_pattern(Draft& draft) {
  Dice& dice = draft.dice;
  const bool in_the_round = dice.chance(0.1);
  const int most = dice.chance(0.12) ? 6 : 4;
  const int courses = dice.between(3, most), wales = in_the_round ? 5 : dice.between(3, most);
  const std::string size = std::to_string(courses) + "x" + std::to_string(wales) + (in_the_round ? " round " : " ");
  if (dice.chance(0.35)) {
    draft.say(size + "irregular");
    return irregular(dice, courses, wales, in_the_round);
  }
  constexpr std::array kNames{"stockinette", "reverse_stockinette", "garter", "rib", "seed"};
  PresetSpec preset{dice.pick(kNames), courses, wales};
  preset.rib_knits = dice.between(1, 2);
  preset.rib_purls = dice.between(1, 2);
  draft.say(size + preset.name);
  Issues none;
  return pattern_from_preset(preset, in_the_round, "preset", none);
}

Gauge random_gauge(Draft& draft) {
  const double of_usual = draft.dice.uniform(0.85, 1.3), taller = draft.dice.uniform(0.85, 1.2);
  const double course = kCourseSpacing * of_usual * draft.radius(),
               wale = kWaleSpacing * of_usual * taller * draft.radius();
  if (draft.dice.chance(0.25)) return {std::nullopt, std::nullopt, 2.0 * course + 2.5 * wale};
  return {course, wale, std::nullopt};
}

void add_knit(Draft& draft) {
  Knit& knit = draft.scene.knit.emplace();
  knit.pattern = random_pattern(draft);
  knit.gauge = random_gauge(draft);
  knit.placement.origin_m = draft.dice.uniform(0.0, 20.0) * draft.radius() * draft.dice.direction();
  if (draft.dice.chance(0.5)) {
    knit.placement.course_direction = draft.dice.direction();
    knit.placement.wale_direction = knit.placement.course_direction.cross(draft.dice.direction());
  }
  const Repeat repeat = smallest_repeat(knit.pattern);
  knit.relax_repeat = repeat.courses * repeat.wales <= 9 && draft.dice.chance(0.7);
  if (!draft.dice.chance(0.3)) return;
  knit.noise_m = draft.radius() * draft.dice.log_uniform(1e-3, 0.2);
  knit.noise_seed = static_cast<std::uint64_t>(draft.dice.between(0, 1000));
  draft.say("noise");
}

/// From `from` on along x, every point up to `uneven` of a piece beside the line.
BareYarn wavy(Draft& draft, const Vec3& from, int pieces, double uneven) {
  BareYarn yarn;
  const double piece = draft.radius() * draft.dice.uniform(4.0, 10.0);
  for (int i = 0; i <= pieces; ++i)
    yarn.points.push_back(from + piece * (i * Vec3::UnitX() + uneven * draft.dice.unit() * draft.dice.direction()));
  if (draft.dice.chance(0.5)) yarn.prestretch = draft.dice.uniform(0.92, 1.08);
  return yarn;
}

/// Side by side, some drawn over guides.
void add_strands(Draft& draft, int count, const Vec3& from) {
  const double apart = draft.radius() * draft.dice.uniform(14.0, 20.0);  // no two can touch at the start
  for (int y = 0; y < count; ++y) {
    const int pieces = draft.dice.between(4, 12);
    draft.scene.yarns.push_back(wavy(draft, from + y * apart * Vec3::UnitZ(), pieces, draft.dice.uniform(0.0, 0.5)));
    if (draft.dice.chance(0.4)) draft.scene.guides.push_back({y, draft.dice.between(1, pieces - 1)});
  }
  draft.say(std::to_string(count) + " strands, " + std::to_string(draft.scene.guides.size()) + " guides");
}

/// Yarns along x that share a sliding contact with each of those along z.
void add_net(Draft& draft) {
  const int across = draft.dice.between(1, 3), along = draft.dice.between(1, 3);
  const double piece = draft.radius() * draft.dice.uniform(4.0, 10.0);
  const auto add = [&](int count, const Vec3& forth, const Vec3& beside, int others) {
    for (int y = 1; y <= count; ++y) {
      BareYarn& yarn = draft.scene.yarns.emplace_back();
      for (int i = 0; i <= 2 * (others + 1); ++i) yarn.points.push_back(piece * (i * forth + 2 * y * beside));
    }
  };
  add(along, Vec3::UnitX(), Vec3::UnitZ(), across);
  add(across, Vec3::UnitZ(), Vec3::UnitX(), along);
  for (int a = 0; a < along; ++a)
    for (int b = 0; b < across; ++b) draft.scene.crossings.push_back({a, 2 * (b + 1), along + b, 2 * (a + 1)});
  draft.say("net " + std::to_string(along) + "x" + std::to_string(across));
}

}  // namespace

void draw_times(Draft& draft) {
  draft.steps = draft.dice.between(16, 30);
  draft.step_s = draft.dice.log_uniform(1e-4, 1.0 / 30.0);
  Scene& scene = draft.scene;
  scene.duration_s = draft.duration_s();
  scene.frames_per_s = 1.0 / (draft.dice.between(1, 10) * draft.step_s);
  FixedNumerics numerics;
  numerics.time_step_s = draft.step_s;
  if (draft.dice.chance(0.7)) numerics.max_newton_iterations = 200;  // else the default
  numerics.velocity_tolerance_m_per_s = draft.dice.log_uniform(1e-6, 2e-4);
  scene.numerics = numerics;
}

void draw_material(Draft& draft) {
  Dice& dice = draft.dice;
  YarnMaterial& yarn = draft.scene.yarn;
  const double size = dice.log_uniform(0.1, 10.0), area = size * size;
  yarn.radius_m = kUsualRadius * size;
  yarn.linear_density_kg_per_m *= area * dice.log_uniform(0.125, 8.0);
  yarn.stretch_n *= area * dice.log_uniform(1.0 / 32.0, 32.0);
  // No yarn resists bending more than a rod of one piece, whose EI is EA R^2 / 4.
  yarn.bending_nm2 = yarn.stretch_n * yarn.radius_m * yarn.radius_m * dice.log_uniform(1e-4, 0.1);
}

void draw_fabric(Draft& draft) {
  const double kind = draft.dice.unit();
  if (kind < 0.78) add_knit(draft);
  if (kind >= 0.9) return add_net(draft);
  if (kind < 0.7) return;
  // Beside a knit, where there is one.
  const Vec3 from = draft.scene.knit
                        ? Vec3(-20.0 * draft.radius() * Vec3::UnitX() + 60.0 * draft.radius() * Vec3::UnitZ())
                        : Vec3(Vec3::Zero());
  add_strands(draft, draft.scene.knit ? 1 : draft.dice.between(1, 3), from);
}

}  // namespace slipstitch::gauntlet
