// SPDX-License-Identifier: MIT
#include "report/effect_columns.h"

#include <array>
#include <cmath>

#include "report/number_text.h"

namespace slipstitch {
namespace {

double ratio(double with, double without) {
  if (with == without) return 1.0;  // both 0 too
  return without > 0.0 ? with / without : std::nan("");
}

template <auto kField>
double side_ratio(const EffectPrice& price, const EffectStudy&) {
  return ratio(static_cast<double>(price.with.*kField), static_cast<double>(price.without.*kField));
}

constexpr std::array kColumns{
    EffectColumn{"max [R]", "largest distance between with and without, of any node at any frame, in yarn radii",
                 [](const EffectPrice& p, const EffectStudy& s) { return p.max_displacement_m / s.radius_m; }},
    EffectColumn{"rms [R]", "the same, root mean square over nodes and frames",
                 [](const EffectPrice& p, const EffectStudy& s) { return p.rms_displacement_m / s.radius_m; }},
    EffectColumn{"tension [N]", "largest tension of any segment at any step, with minus without",
                 [](const EffectPrice& p, const EffectStudy&) { return p.with.tension_n - p.without.tension_n; }},
    EffectColumn{"handles [N]", "largest force on any handle at any step, with minus without",
                 [](const EffectPrice& p, const EffectStudy&) { return p.with.reaction_n - p.without.reaction_n; }},
    EffectColumn{"stored [uJ]", "energy stored in yarn and contacts at the end, with minus without",
                 [](const EffectPrice& p, const EffectStudy&) { return 1e6 * (p.with.stored_j - p.without.stored_j); }},
    EffectColumn{"time x", "wall time, with / without",
                 [](const EffectPrice& p, const EffectStudy&) { return p.time_ratio; }},
    EffectColumn{"memory x", "heap in use at the last step, with / without", side_ratio<&EffectSide::memory_bytes>},
    EffectColumn{"unknowns x", "degrees of freedom, with / without", side_ratio<&EffectSide::dofs>},
    EffectColumn{"nonzeros x", "entries of the Hessian's lower triangle, with / without",
                 side_ratio<&EffectSide::nonzeros>},
    EffectColumn{"Newton x", "Newton iterations, with / without", side_ratio<&EffectSide::newton_iterations>},
    EffectColumn{"factors x", "factorisations of the Hessian, with / without", side_ratio<&EffectSide::factorizations>},
    EffectColumn{"CG x", "iterations of conjugate gradients, with / without", side_ratio<&EffectSide::cg_iterations>},
};

}  // namespace

std::span<const EffectColumn> effect_columns() { return kColumns; }

std::string cell_text(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (size == 0.0) return "0";
  if (size < 1e-3) return short_number(value, 1);
  return size < 1000.0 ? plain_number(value, size < 0.1 ? 2 : 3) : short_number(std::round(value), 6);
}

std::string_view presence_text(const EffectPrice& price) { return price.listed ? "on" : "added"; }

std::string effect_label(const EffectPrice& price) {
  std::string label = price.effect;
  for (std::size_t i = 0; i < price.together.size(); ++i) label += (i == 0 ? " (and " : ", ") + price.together[i];
  return label + (price.together.empty() ? "" : ")");
}

std::string how_to_read() {
  return "Every row compares two runs of the scene, with the effect and without it; an effect that the scene does not "
         "list "
         "is added with its default parameters. A ratio above 1 is what the effect costs, below 1 what it saves. Times "
         "are medians of ratios of runs made one after the other in one process; all other figures are counted.";
}

std::string about_scene(const EffectStudy& study) {
  std::string text = study.loops > 0 ? count_of(study.loops, "loop", "loops") + ", " : "";
  text +=
      count_of(study.itself.dofs, "unknown", "unknowns") + ", " + short_number(study.duration_s) + " s in " +
      count_of(study.itself.steps, "step", "steps") + " and " + thousands(study.itself.newton_iterations) +
      " Newton iterations, " + duration_text(study.itself.wall_s) + " and " + bytes_text(study.itself.memory_bytes) +
      " for the scene as it is; " + count_of(study.rounds, "round", "rounds") +
      (study.rounds > 1 ? (study.repeatable ? ", every run of it equal bit for bit" : ", runs of it NOT equal") : "");
  return text + ".";
}

}  // namespace slipstitch
