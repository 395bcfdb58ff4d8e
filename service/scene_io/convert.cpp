// SPDX-License-Identifier: MIT
#include "scene_io/convert.h"

#include <algorithm>
#include <string>

#include "model/check_values.h"
#include "scene_io/convert_parts.h"

namespace slipstitch {

Vec3 vector_from(const Doubles& numbers, const Vec3& otherwise, const std::string& path, Issues& issues) {
  if (numbers.empty()) return otherwise;
  if (numbers.size() != 3) {
    issues.push_back({path, "an array of " + std::to_string(numbers.size()), "3 numbers: [x, y, z]"});
    return otherwise;
  }
  return {numbers[0], numbers[1], numbers[2]};
}

void add_vector(const Vec3& vector, Doubles& numbers) {
  for (double component : vector) numbers.Add(component);
}

YarnMaterial material_from_message(const v1::YarnMaterial& message) {
  YarnMaterial yarn;
  if (message.has_radius_m()) yarn.radius_m = message.radius_m();
  if (message.has_linear_density_kg_per_m()) yarn.linear_density_kg_per_m = message.linear_density_kg_per_m();
  if (message.has_stretch_n()) yarn.stretch_n = message.stretch_n();
  if (message.has_bending_nm2()) yarn.bending_nm2 = message.bending_nm2();
  return yarn;
}

void write_material(const YarnMaterial& yarn, v1::YarnMaterial& message) {
  message.set_radius_m(yarn.radius_m);
  message.set_linear_density_kg_per_m(yarn.linear_density_kg_per_m);
  message.set_stretch_n(yarn.stretch_n);
  message.set_bending_nm2(yarn.bending_nm2);
}

namespace {

std::string indexed(const std::string& path, int index) { return path + "[" + std::to_string(index) + "]"; }

// --- knit

using Rows = google::protobuf::RepeatedPtrField<std::string>;

// Rows are letters only once there are not too many of either.
bool rows_fit(const Rows& rows, const std::string& path, const SceneLimits& limits, Issues& issues) {
  std::size_t stitches = 0;
  for (const std::string& row : rows) stitches += std::max<std::size_t>(row.size(), 1);
  if (stitches <= static_cast<std::size_t>(std::max(limits.max_stitches, 0))) return true;
  issues.push_back(too_many(path, std::to_string(stitches), limits.max_stitches, "stitches"));
  return false;
}

Pattern rows_from(const Rows& rows, const std::string& path, bool round, decltype(pattern_from_chart)& read,
                  const SceneLimits& limits, Issues& issues) {
  if (!rows_fit(rows, path, limits, issues)) return {};
  return read({rows.begin(), rows.end()}, round, path, issues);
}

bool preset_fits(const v1::Preset& preset, const SceneLimits& limits, Issues& issues) {
  const std::int64_t stitches = std::int64_t{preset.courses()} * preset.wales();
  if (preset.courses() <= 0 || preset.wales() <= 0 || stitches <= limits.max_stitches) return true;
  issues.push_back(too_many("knit.preset", std::to_string(stitches), limits.max_stitches, "stitches"));
  return false;
}

Pattern preset_from(const v1::Preset& message, bool in_the_round, const SceneLimits& limits, Issues& issues) {
  if (!preset_fits(message, limits, issues)) return {};
  PresetSpec preset;
  preset.name = message.name();
  preset.courses = message.courses();
  preset.wales = message.wales();
  if (message.has_rib_knits()) preset.rib_knits = message.rib_knits();
  if (message.has_rib_purls()) preset.rib_purls = message.rib_purls();
  return pattern_from_preset(preset, in_the_round, "knit.preset", issues);
}

Pattern pattern_from(const v1::Knit& message, const SceneLimits& limits, Issues& issues) {
  const bool round = message.in_the_round();
  switch (message.pattern_case()) {
    case v1::Knit::kChart:
      return rows_from(message.chart().rows(), "knit.chart.rows", round, pattern_from_chart, limits, issues);
    case v1::Knit::kPreset:
      return preset_from(message.preset(), round, limits, issues);
    case v1::Knit::kWorkedRows:
      return rows_from(message.worked_rows().rows(), "knit.worked_rows.rows", round, pattern_from_worked_rows, limits,
                       issues);
    case v1::Knit::PATTERN_NOT_SET:
      issues.push_back({"knit", "without a pattern", "chart, preset or worked_rows"});
  }
  return {};
}

Gauge gauge_from(const v1::Gauge& message) {
  Gauge gauge;
  if (message.has_course_spacing_m()) gauge.course_spacing_m = message.course_spacing_m();
  if (message.has_wale_spacing_m()) gauge.wale_spacing_m = message.wale_spacing_m();
  if (message.has_yarn_per_stitch_m()) gauge.yarn_per_stitch_m = message.yarn_per_stitch_m();
  return gauge;
}

Placement placement_from(const v1::Placement& message, Issues& issues) {
  const std::string path = "knit.placement.";
  Placement placement;
  placement.origin_m = vector_from(message.origin_m(), placement.origin_m, path + "origin_m", issues);
  placement.course_direction =
      vector_from(message.course_direction(), placement.course_direction, path + "course_direction", issues);
  placement.wale_direction =
      vector_from(message.wale_direction(), placement.wale_direction, path + "wale_direction", issues);
  return placement;
}

Knit knit_from(const v1::Knit& message, const SceneLimits& limits, Issues& issues) {
  Knit knit;
  knit.pattern = pattern_from(message, limits, issues);
  knit.gauge = gauge_from(message.gauge());
  knit.placement = placement_from(message.placement(), issues);
  if (message.has_relax_repeat()) knit.relax_repeat = message.relax_repeat();
  knit.noise_m = message.noise_m();
  knit.noise_seed = message.noise_seed();
  knit.ends_woven_in = message.ends_woven_in();
  knit.refine = message.refine();
  return knit;
}

void write_knit(const Knit& knit, v1::Knit& message) {
  const Pattern& pattern = knit.pattern;
  message.mutable_chart();
  for (int course = pattern.courses; course >= 1; --course) {
    std::string& row = *message.mutable_chart()->add_rows();
    for (int wale = 1; wale <= pattern.wales; ++wale) row += pattern.at(course, wale) == StitchKind::knit ? 'K' : 'P';
  }
  message.set_in_the_round(pattern.in_the_round);
  v1::Gauge& gauge = *message.mutable_gauge();
  if (knit.gauge.course_spacing_m) gauge.set_course_spacing_m(*knit.gauge.course_spacing_m);
  if (knit.gauge.wale_spacing_m) gauge.set_wale_spacing_m(*knit.gauge.wale_spacing_m);
  if (knit.gauge.yarn_per_stitch_m) gauge.set_yarn_per_stitch_m(*knit.gauge.yarn_per_stitch_m);
  v1::Placement& placement = *message.mutable_placement();
  add_vector(knit.placement.origin_m, *placement.mutable_origin_m());
  add_vector(knit.placement.course_direction, *placement.mutable_course_direction());
  add_vector(knit.placement.wale_direction, *placement.mutable_wale_direction());
  message.set_relax_repeat(knit.relax_repeat);
  message.set_noise_m(knit.noise_m);
  message.set_noise_seed(knit.noise_seed);
  message.set_ends_woven_in(knit.ends_woven_in);
  message.set_refine(knit.refine);
}

// --- yarns

BareYarn bare_yarn_from(const v1::BareYarn& message, const std::string& path, Issues& issues) {
  BareYarn yarn;
  const Doubles& numbers = message.points_m();
  if (numbers.size() % 3 != 0) {
    issues.push_back({path + ".points_m", "an array of " + std::to_string(numbers.size()),
                      "a multiple of 3 numbers: x, y, z of every point"});
  }
  for (int i = 0; i + 2 < numbers.size(); i += 3) yarn.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  if (message.has_prestretch()) yarn.prestretch = message.prestretch();
  yarn.arc_lengths_m.assign(message.arc_lengths_m().begin(), message.arc_lengths_m().end());
  yarn.velocity_m_per_s =
      vector_from(message.velocity_m_per_s(), yarn.velocity_m_per_s, path + ".velocity_m_per_s", issues);
  return yarn;
}

void write_bare_yarn(const BareYarn& yarn, v1::BareYarn& message) {
  for (const Vec3& point : yarn.points) add_vector(point, *message.mutable_points_m());
  message.set_prestretch(yarn.prestretch);
  message.mutable_arc_lengths_m()->Add(yarn.arc_lengths_m.begin(), yarn.arc_lengths_m.end());
  add_vector(yarn.velocity_m_per_s, *message.mutable_velocity_m_per_s());
}

// --- handles and loads

Corner corner_from(v1::Selector::Corner corner, const std::string& path, Issues& issues) {
  switch (corner) {
    case v1::Selector::BOTTOM_LEFT:
      return Corner::bottom_left;
    case v1::Selector::BOTTOM_RIGHT:
      return Corner::bottom_right;
    case v1::Selector::TOP_LEFT:
      return Corner::top_left;
    case v1::Selector::TOP_RIGHT:
      return Corner::top_right;
    default:
      break;
  }
  issues.push_back(
      {path, std::to_string(static_cast<int>(corner)), "BOTTOM_LEFT, BOTTOM_RIGHT, TOP_LEFT or TOP_RIGHT"});
  return Corner::bottom_left;
}

Edge edge_from(v1::Selector::Edge edge, const std::string& path, Issues& issues) {
  switch (edge) {
    case v1::Selector::BOTTOM:
      return Edge::bottom;
    case v1::Selector::TOP:
      return Edge::top;
    case v1::Selector::LEFT:
      return Edge::left;
    case v1::Selector::RIGHT:
      return Edge::right;
    default:
      break;
  }
  issues.push_back({path, std::to_string(static_cast<int>(edge)), "BOTTOM, TOP, LEFT or RIGHT"});
  return Edge::bottom;
}

StitchRange stitches_from(const v1::StitchRange& message) {
  StitchRange range;
  if (message.has_first_course()) range.first_course = message.first_course();
  if (message.has_last_course()) range.last_course = message.last_course();
  if (message.has_first_wale()) range.first_wale = message.first_wale();
  if (message.has_last_wale()) range.last_wale = message.last_wale();
  return range;
}

Selector selector_from(const v1::Selector& message, const std::string& path, Issues& issues) {
  switch (message.where_case()) {
    case v1::Selector::kCorner:
      return corner_from(message.corner(), path + ".corner", issues);
    case v1::Selector::kEdge:
      return edge_from(message.edge(), path + ".edge", issues);
    case v1::Selector::kStitches:
      return stitches_from(message.stitches());
    case v1::Selector::kYarnPoint:
      return YarnPoint{message.yarn_point().yarn(), message.yarn_point().point()};
    case v1::Selector::kAll:
      return AllNodes{};
    case v1::Selector::WHERE_NOT_SET:
      break;
  }
  issues.push_back({path, "empty", "one of corner, edge, stitches, yarn_point and all"});
  return AllNodes{};
}

/// One overload for each alternative of Selector.
struct SelectorWriter {
  v1::Selector& message;
  void operator()(Corner corner) const {
    message.set_corner(static_cast<v1::Selector::Corner>(static_cast<int>(corner) + 1));
  }
  void operator()(Edge edge) const { message.set_edge(static_cast<v1::Selector::Edge>(static_cast<int>(edge) + 1)); }
  void operator()(const StitchRange& range) const {
    v1::StitchRange& stitches = *message.mutable_stitches();
    stitches.set_first_course(range.first_course);
    stitches.set_last_course(range.last_course);
    stitches.set_first_wale(range.first_wale);
    stitches.set_last_wale(range.last_wale);
  }
  void operator()(const YarnPoint& point) const {
    message.mutable_yarn_point()->set_yarn(point.yarn);
    message.mutable_yarn_point()->set_point(point.point);
  }
  void operator()(const AllNodes&) const { message.mutable_all(); }
};

Handle handle_from(const v1::Handle& message, const std::string& path, Issues& issues) {
  Handle handle;
  handle.where = selector_from(message.where(), path + ".where", issues);
  handle.motion = motion_from(message.motion(), path + ".motion", issues);
  handle.fix_arc_length = message.fix_arc_length();
  if (!message.velocity_m_per_s().empty()) {
    handle.velocity_m_per_s = vector_from(message.velocity_m_per_s(), Vec3::Zero(), path + ".velocity_m_per_s", issues);
  }
  return handle;
}

void write_handle(const Handle& handle, v1::Handle& message) {
  std::visit(SelectorWriter{*message.mutable_where()}, handle.where);
  write_motion(handle.motion, *message.mutable_motion());
  message.set_fix_arc_length(handle.fix_arc_length);
  if (handle.velocity_m_per_s) add_vector(*handle.velocity_m_per_s, *message.mutable_velocity_m_per_s());
}

// --- numerics

Integrator integrator_from(v1::FixedNumerics::Integrator integrator, Issues& issues) {
  switch (integrator) {
    case v1::FixedNumerics::IMPLICIT_EULER:
      return Integrator::implicit_euler;
    case v1::FixedNumerics::BDF2:
      return Integrator::bdf2;
    case v1::FixedNumerics::SDIRK2:
      return Integrator::sdirk2;
    case v1::FixedNumerics::IMPLICIT_MIDPOINT:
      return Integrator::implicit_midpoint;
    case v1::FixedNumerics::LINEARISED_EULER:
      return Integrator::linearised_euler;
    default:
      break;
  }
  issues.push_back({"fixed.integrator", std::to_string(static_cast<int>(integrator)),
                    "IMPLICIT_EULER, BDF2, SDIRK2, IMPLICIT_MIDPOINT or LINEARISED_EULER"});
  return Integrator::implicit_euler;
}

FixedNumerics fixed_from(const v1::FixedNumerics& message, Issues& issues) {
  FixedNumerics fixed;
  if (message.has_time_step_s()) fixed.time_step_s = message.time_step_s();
  if (message.has_velocity_tolerance_m_per_s()) fixed.velocity_tolerance_m_per_s = message.velocity_tolerance_m_per_s();
  if (message.has_force_tolerance_n()) fixed.force_tolerance_n = message.force_tolerance_n();
  if (message.has_max_newton_iterations()) fixed.max_newton_iterations = message.max_newton_iterations();
  if (message.has_smallest_step_s()) fixed.smallest_step_s = message.smallest_step_s();
  if (message.has_integrator()) fixed.integrator = integrator_from(message.integrator(), issues);
  return fixed;
}

void write_fixed(const FixedNumerics& fixed, v1::FixedNumerics& message) {
  message.set_time_step_s(fixed.time_step_s);
  message.set_velocity_tolerance_m_per_s(fixed.velocity_tolerance_m_per_s);
  message.set_force_tolerance_n(fixed.force_tolerance_n);
  message.set_max_newton_iterations(fixed.max_newton_iterations);
  message.set_smallest_step_s(fixed.smallest_step_s);
  message.set_integrator(static_cast<v1::FixedNumerics::Integrator>(static_cast<int>(fixed.integrator) + 1));
}

/// By its own choice; without one the problem is told, and any that is sound stands in.
void read_accuracy(const v1::Accuracy& message, Scene& scene, Issues& issues) {
  switch (message.goal_case()) {
    case v1::Accuracy::kToleranceM:
      scene.numerics = AccuracyNumerics{message.tolerance_m()};
      return;
    case v1::Accuracy::kBudgetS:
      scene.numerics = BudgetNumerics{message.budget_s()};
      return;
    case v1::Accuracy::GOAL_NOT_SET:
      break;
  }
  issues.push_back({"accuracy", "empty", "either tolerance_m or budget_s"});
  scene.numerics = AccuracyNumerics{AccuracyNumerics::kLeastTolerance_m};
}

// --- the parts of a scene

void read_bare_yarns(const v1::Scene& message, Scene& scene, Issues& issues) {
  for (int i = 0; i < message.yarns_size(); ++i) {
    scene.yarns.push_back(bare_yarn_from(message.yarns(i), indexed("yarns", i), issues));
  }
  for (const v1::Guide& guide : message.guides()) scene.guides.push_back({guide.yarn(), guide.point()});
  for (const v1::Crossing& crossing : message.crossings()) {
    scene.crossings.push_back({crossing.yarn_a(), crossing.point_a(), crossing.yarn_b(), crossing.point_b()});
  }
}

void read_actions(const v1::Scene& message, Scene& scene, Issues& issues) {
  for (int i = 0; i < message.handles_size(); ++i) {
    scene.handles.push_back(handle_from(message.handles(i), indexed("handles", i), issues));
  }
  for (int i = 0; i < message.loads_size(); ++i) {
    const std::string path = indexed("loads", i);
    Load& load = scene.loads.emplace_back();
    load.where = selector_from(message.loads(i).where(), path + ".where", issues);
    load.force_n = vector_from(message.loads(i).force_n(), load.force_n, path + ".force_n", issues);
  }
  for (int i = 0; i < message.initial_velocities_size(); ++i) {
    const v1::InitialVelocity& from = message.initial_velocities(i);
    const std::string path = indexed("initial_velocities", i);
    InitialVelocity& start = scene.initial_velocities.emplace_back();
    start.where = selector_from(from.where(), path + ".where", issues);
    start.velocity_m_per_s =
        vector_from(from.velocity_m_per_s(), start.velocity_m_per_s, path + ".velocity_m_per_s", issues);
  }
}

void write_bare_yarns(const Scene& scene, v1::Scene& message) {
  for (const BareYarn& yarn : scene.yarns) write_bare_yarn(yarn, *message.add_yarns());
  for (const Guide& guide : scene.guides) {
    v1::Guide& to = *message.add_guides();
    to.set_yarn(guide.yarn);
    to.set_point(guide.point);
  }
  for (const Crossing& crossing : scene.crossings) {
    v1::Crossing& to = *message.add_crossings();
    to.set_yarn_a(crossing.yarn_a);
    to.set_point_a(crossing.point_a);
    to.set_yarn_b(crossing.yarn_b);
    to.set_point_b(crossing.point_b);
  }
}

void write_actions(const Scene& scene, v1::Scene& message) {
  for (const Handle& handle : scene.handles) write_handle(handle, *message.add_handles());
  for (const Load& load : scene.loads) {
    v1::Load& to = *message.add_loads();
    std::visit(SelectorWriter{*to.mutable_where()}, load.where);
    add_vector(load.force_n, *to.mutable_force_n());
  }
  for (const InitialVelocity& start : scene.initial_velocities) {
    v1::InitialVelocity& to = *message.add_initial_velocities();
    std::visit(SelectorWriter{*to.mutable_where()}, start.where);
    add_vector(start.velocity_m_per_s, *to.mutable_velocity_m_per_s());
  }
}

}  // namespace

Scene scene_from_message(const v1::Scene& message, Issues& issues, const SceneLimits& limits) {
  Scene scene;
  scene.name = message.name();
  if (message.has_knit()) scene.knit = knit_from(message.knit(), limits, issues);
  read_bare_yarns(message, scene, issues);
  scene.yarn = material_from_message(message.yarn());
  scene.effects = effects_from_message(message.effects(), issues);
  read_actions(message, scene, issues);
  if (message.has_duration_s()) scene.duration_s = message.duration_s();
  if (message.has_frames_per_s()) scene.frames_per_s = message.frames_per_s();
  if (message.has_accuracy()) {
    read_accuracy(message.accuracy(), scene, issues);
  } else {
    scene.numerics = fixed_from(message.fixed(), issues);
  }
  return scene;
}

v1::Scene message_from_scene(const Scene& scene) {
  v1::Scene message;
  message.set_name(scene.name);
  if (scene.knit) write_knit(*scene.knit, *message.mutable_knit());
  write_bare_yarns(scene, message);
  write_material(scene.yarn, *message.mutable_yarn());
  write_effects(scene.effects, *message.mutable_effects());
  write_actions(scene, message);
  message.set_duration_s(scene.duration_s);
  message.set_frames_per_s(scene.frames_per_s);
  if (const auto* accuracy = std::get_if<AccuracyNumerics>(&scene.numerics)) {
    message.mutable_accuracy()->set_tolerance_m(accuracy->tolerance_m);
  } else if (const auto* budget = std::get_if<BudgetNumerics>(&scene.numerics)) {
    message.mutable_accuracy()->set_budget_s(budget->budget_s);
  } else {
    write_fixed(std::get<FixedNumerics>(scene.numerics), *message.mutable_fixed());
  }
  return message;
}

}  // namespace slipstitch
