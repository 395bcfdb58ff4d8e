// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/formats.h"

namespace slipstitch {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json slice(const std::vector<double>& values, int first, int end) {
  Json array = Json::array();
  for (int i = first; i < end; ++i) array.push_back(number(values[static_cast<std::size_t>(i)]));
  return array;
}

Json yarn_json(const CurveFrame& frame, int first, int end) {
  Json points = Json::array();
  for (int i = first; i < end; ++i) {
    const Vec3& x = frame.points[static_cast<std::size_t>(i)];
    points.push_back({x[0], x[1], x[2]});
  }
  return {{"points_m", std::move(points)},
          {"arc_length_m", slice(frame.arc_length_m, first, end)},
          {"slid_m", slice(frame.slid_m, first, end)},
          {"tension_n", slice(frame.tension_n, first, end)}};
}

}  // namespace

std::string write_json(const CurveFrame& frame) {
  Json document{{"frame", frame.index}, {"t_s", frame.t}, {"radius_m", frame.radius_m}};
  document["yarns"] = Json::array();
  for (std::size_t yarn = 0; yarn + 1 < frame.first.size(); ++yarn) {
    document["yarns"].push_back(yarn_json(frame, frame.first[yarn], frame.first[yarn + 1]));
  }
  document["wrap_rad"] = Json::array();
  for (const auto& [a, b] : frame.wrap_rad) document["wrap_rad"].push_back({number(a), number(b)});
  return document.dump() + "\n";
}

}  // namespace slipstitch
