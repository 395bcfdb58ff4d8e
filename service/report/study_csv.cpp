// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "report/csv_text.h"
#include "report/number_text.h"
#include "report/study_report.h"

namespace slipstitch {
namespace {

using Cell = std::optional<double>;

Cell error_of(const RungResult& r, double RungErrors::*field) {
  return r.errors ? Cell((*r.errors).*field) : std::nullopt;
}

Cell factor_of(const std::optional<Speedup>& speedup) { return speedup ? Cell(speedup->factor) : std::nullopt; }
Cell extrapolated(const std::optional<Speedup>& speedup) {
  return speedup ? Cell(speedup->extrapolated ? 1.0 : 0.0) : std::nullopt;
}

struct Field {
  const char* name;
  Cell (*value)(const RungResult& r, const WorkPrecision& study);
};

constexpr std::array kFields{
    Field{"times", [](const RungResult& r, const WorkPrecision&) { return Cell(r.times); }},
    Field{"wall_s", [](const RungResult& r, const WorkPrecision&) { return Cell(r.wall_s); }},
    Field{"memory_bytes", [](const RungResult& r, const WorkPrecision&) { return Cell(r.memory_bytes); }},
    Field{"steps", [](const RungResult& r, const WorkPrecision&) { return Cell(r.steps); }},
    Field{"rejected_steps", [](const RungResult& r, const WorkPrecision&) { return Cell(r.rejected_steps); }},
    Field{"newton_iterations", [](const RungResult& r, const WorkPrecision&) { return Cell(r.newton_iterations); }},
    Field{"factorizations", [](const RungResult& r, const WorkPrecision&) { return Cell(r.factorizations); }},
    Field{"cg_iterations", [](const RungResult& r, const WorkPrecision&) { return Cell(r.cg_iterations); }},
    Field{"error_estimate_m", [](const RungResult& r, const WorkPrecision&) { return r.error_estimate_m; }},
    Field{"position_error_m",
          [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::position_m); }},
    Field{"position_error_of_95_percent_m",
          [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::most_m); }},
    Field{"position_rms_m", [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::rms_m); }},
    Field{"stored_error_j",
          [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::stored_j); }},
    Field{"force_error_n", [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::force_n); }},
    Field{"length_error_m",
          [](const RungResult& r, const WorkPrecision&) { return error_of(r, &RungErrors::length_m); }},
    Field{"order", [](const RungResult& r, const WorkPrecision&) { return r.order; }},
    Field{"resolved", [](const RungResult& r, const WorkPrecision&) { return Cell(r.resolved ? 1.0 : 0.0); }},
    Field{"predictable_until_s", [](const RungResult& r, const WorkPrecision&) { return r.predictable_until_s; }},
    Field{"speedup", [](const RungResult& r, const WorkPrecision&) { return factor_of(r.speedup); }},
    Field{"speedup_extrapolated", [](const RungResult& r, const WorkPrecision&) { return extrapolated(r.speedup); }},
    Field{"speedup_of_95_percent", [](const RungResult& r, const WorkPrecision&) { return factor_of(r.speedup_most); }},
    Field{"speedup_of_95_percent_extrapolated",
          [](const RungResult& r, const WorkPrecision&) { return extrapolated(r.speedup_most); }},
    Field{"on_front", [](const RungResult& r, const WorkPrecision&) { return Cell(r.on_front ? 1.0 : 0.0); }},
    Field{"reference_step_s",
          [](const RungResult&, const WorkPrecision& s) {
            return s.reference.refinements > 0 ? Cell(s.reference.step_s) : std::nullopt;
          }},
    Field{"reference_error_m", [](const RungResult&, const WorkPrecision& s) { return s.reference.error_m; }},
    Field{"horizon_s", [](const RungResult&, const WorkPrecision& s) { return s.horizon_s; }},
};

std::string number(Cell value) { return value && std::isfinite(*value) ? short_number(*value, 9) : std::string(); }

}  // namespace

std::string study_csv(const WorkPrecision& study) {
  std::string text = "scene,rung,method,step_s,tolerance_m,failed,no_result";
  for (const Field& field : kFields) text += std::string(",") + field.name;
  text += "\n";
  for (const RungResult& r : study.rungs) {
    const bool by_tolerance = r.rung.method == kAccuracyMethod;
    const std::string size = short_number(r.rung.size, 9);
    text += quoted(study.scene) + "," + quoted(rung_name(r.rung)) + "," + r.rung.method + "," +
            (by_tolerance ? "" : size) + "," + (by_tolerance ? size : "") + "," + (r.failed ? "1" : "0") + "," +
            quoted(r.no_result);
    for (const Field& field : kFields) text += "," + (r.no_result.empty() ? number(field.value(r, study)) : "");
    text += "\n";
  }
  return text;
}

}  // namespace slipstitch
