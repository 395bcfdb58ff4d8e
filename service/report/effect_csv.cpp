// SPDX-License-Identifier: MIT
#include <array>

#include "report/csv_text.h"
#include "report/effect_report.h"
#include "report/number_text.h"

namespace slipstitch {
namespace {

struct SideField {
  const char* name;
  double (*value)(const EffectSide& side);
};

constexpr std::array kFields{
    SideField{"wall_s", [](const EffectSide& s) { return s.wall_s; }},
    SideField{"memory_bytes", [](const EffectSide& s) { return s.memory_bytes; }},
    SideField{"dofs", [](const EffectSide& s) { return static_cast<double>(s.dofs); }},
    SideField{"nonzeros", [](const EffectSide& s) { return static_cast<double>(s.nonzeros); }},
    SideField{"steps", [](const EffectSide& s) { return static_cast<double>(s.steps); }},
    SideField{"newton_iterations", [](const EffectSide& s) { return static_cast<double>(s.newton_iterations); }},
    SideField{"factorizations", [](const EffectSide& s) { return static_cast<double>(s.factorizations); }},
    SideField{"cg_iterations", [](const EffectSide& s) { return static_cast<double>(s.cg_iterations); }},
    SideField{"stored_j", [](const EffectSide& s) { return s.stored_j; }},
    SideField{"max_tension_n", [](const EffectSide& s) { return s.tension_n; }},
    SideField{"max_reaction_n", [](const EffectSide& s) { return s.reaction_n; }},
};

void append_sides(const EffectPrice& price, std::string& row) {
  for (const SideField& field : kFields)
    for (const EffectSide* side : {&price.with, &price.without})
      row += "," + (price.not_compared.empty() ? short_number(field.value(*side), 9) : std::string());
}

void append_study(const EffectStudy& study, std::string& text) {
  for (const EffectPrice& price : study.prices) {
    std::string together;
    for (const std::string& name : price.together) together += (together.empty() ? "" : " ") + name;
    text += quoted(study.scene) + "," + price.effect + "," + (price.listed ? "1" : "0") + "," + together + "," +
            quoted(price.not_compared) + "," + std::to_string(study.rounds) + "," + short_number(study.radius_m, 9);
    const double radius = study.radius_m;
    for (const double value : {price.max_displacement_m, price.rms_displacement_m, price.max_displacement_m / radius,
                               price.rms_displacement_m / radius, price.time_ratio})
      text += "," + (price.not_compared.empty() ? short_number(value, 9) : std::string());
    append_sides(price, text);
    text += "\n";
  }
}

}  // namespace

std::string effect_csv(std::span<const EffectReport> reports) {
  std::string text =
      "scene,effect,listed,together,not_compared,rounds,radius_m,max_displacement_m,rms_displacement_m,"
      "max_displacement_radii,rms_displacement_radii,time_ratio";
  for (const SideField& field : kFields) text += std::string(",with_") + field.name + ",without_" + field.name;
  text += "\n";
  for (const EffectReport& report : reports) append_study(report.study, text);
  return text;
}

}  // namespace slipstitch
