// SPDX-License-Identifier: MIT
#include "studies/study_json.h"

#include "report/study_report.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json rung_json(const RungResult& r) {
  Json json{{"rung", rung_name(r.rung)}, {"method", r.rung.method}};
  if (!r.no_result.empty()) {
    json["no_result"] = r.no_result;
    return json;
  }
  json["wall_s"] = r.wall_s;
  json["newton_iterations"] = r.newton_iterations;
  json["position_error_m"] = r.errors ? Json(r.errors->position_m) : Json();
  json["error_estimate_m"] = or_null(r.error_estimate_m);
  for (const auto& [key, speedup] :
       {std::pair{"speedup", &r.speedup}, std::pair{"speedup_of_95_percent", &r.speedup_most}})
    json[key] = *speedup ? Json{{"factor", (*speedup)->factor}, {"extrapolated", (*speedup)->extrapolated}} : Json();
  json["on_front"] = r.on_front;
  return json;
}

}  // namespace

Json study_json(const WorkPrecision& study) {
  auto rungs = Json::array();
  for (const RungResult& result : study.rungs) rungs.push_back(rung_json(result));
  const StudyReference& reference = study.reference;
  return {{"csv", "study.csv"},
          {"page", "study.html"},
          {"plots", {study_plot_file(StudyAxis::wall_time), study_plot_file(StudyAxis::newton_iterations)}},
          {"scene", study.scene},
          {"finished", !study.stopped && study.failure.empty()},
          {"reference",
           {{"method", reference.method},
            {"step_s", reference.refinements > 0 ? Json(reference.step_s) : Json()},
            {"error_m", or_null(reference.error_m)},
            {"settled", reference.settled}}},
          {"horizon_s", or_null(study.horizon_s)},
          {"digit_factor", or_null(study.digit_factor)},
          {"rungs", rungs}};
}

}  // namespace slipstitch
