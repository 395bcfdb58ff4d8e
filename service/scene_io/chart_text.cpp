// SPDX-License-Identifier: MIT
#include "scene_io/chart_text.h"

namespace slipstitch {
namespace {

constexpr char kBlanks[] = " \t\r";

std::string_view trimmed(std::string_view line) {
  std::size_t first = line.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

void hold(v1::Scene& scene, v1::Selector::Corner corner) { scene.add_handles()->mutable_where()->set_corner(corner); }

void lay_horizontally(v1::Knit& knit) {
  for (double component : {1.0, 0.0, 0.0}) knit.mutable_placement()->add_course_direction(component);
  for (double component : {0.0, 0.0, -1.0}) knit.mutable_placement()->add_wale_direction(component);  // right side up
}

void switch_all_on(v1::Effects& effects) {
  effects.mutable_inertia();
  effects.mutable_gravity();
  effects.mutable_stretch();
  effects.mutable_bending();
  effects.mutable_bending_jamming();
  effects.mutable_wrapping()->set_alpha(0.03);  // at 1 a swatch rolls up before it falls
  effects.mutable_contact_length();
  effects.mutable_parallel_contact();
  effects.mutable_sliding();
  effects.mutable_sliding_friction();
  v1::DampingEffect& damping = *effects.mutable_damping();  // 0.3 s against EI and k_w; with it a swatch rests within 2 s
  damping.set_bending_nm2s(1.35e-8);
  damping.set_wrapping_ns(9e-3);
  damping.set_sliding_ns_per_m(10.0);
}

}  // namespace

ChartText split_chart(std::string_view text) {
  ChartText chart;
  for (int line_number = 1; !text.empty(); ++line_number) {
    std::size_t end = text.find('\n');
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty() || line.front() == '#') continue;
    chart.rows.emplace_back(line);
    chart.lines.push_back(line_number);
  }
  return chart;
}

v1::Scene scene_for_chart(const std::vector<std::string>& rows, const std::string& name) {
  v1::Scene scene;
  scene.set_name(name);
  v1::Knit& knit = *scene.mutable_knit();
  knit.mutable_chart()->mutable_rows()->Add(rows.begin(), rows.end());
  // Near-zero-force cell of worsted acrylic stockinette: Singal et al., Nat. Commun. 15, 2622 (2024).
  knit.mutable_gauge()->set_course_spacing_m(2.9e-3);
  knit.mutable_gauge()->set_wale_spacing_m(2.03e-3);
  lay_horizontally(knit);
  switch_all_on(*scene.mutable_effects());
  hold(scene, v1::Selector::TOP_LEFT);
  hold(scene, v1::Selector::TOP_RIGHT);
  scene.set_duration_s(2.0);
  scene.set_frames_per_s(30.0);
  scene.mutable_fixed()->set_time_step_s(1.0 / 120.0);
  return scene;
}

}  // namespace slipstitch
