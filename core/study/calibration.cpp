// SPDX-License-Identifier: MIT
#include "study/calibration.h"

#include <cmath>

#include "model/scene.h"

namespace slipstitch {
namespace {

constexpr int kSmallest = 6, kLargest = 18;  // courses and wales; of the largest a few iterations are enough
constexpr double kCourse_s = 0.1;            // simulated: the first settling, and a fall that has become smooth
constexpr double kLargest_s = 0.3;           // of wall time
constexpr double kSlowest_s = 5.0;           // of wall time, for a course

Scene hanging_swatch(int size) {
  Scene scene;
  Issues issues;
  scene.knit.emplace().pattern = pattern_from_preset({"stockinette", size, size}, false, "", issues);
  scene.knit->gauge = {2.9e-3, 2.03e-3, {}};
  scene.knit->placement.wale_direction = -Vec3::UnitZ();
  Effects& on = scene.effects;
  on.inertia.emplace();
  on.gravity.emplace();
  on.stretch.emplace();
  on.bending.emplace();
  on.bending_jamming.emplace();
  on.wrapping.emplace().alpha = 0.03;
  on.contact_length.emplace();
  on.parallel_contact.emplace();
  on.sliding.emplace();
  on.sliding_friction.emplace();
  on.damping = DampingEffect{.stretch_ns = 0.0, .bending_nm2s = 1.35e-8, .wrapping_ns = 9e-3, .sliding_ns_per_m = 10.0};
  scene.handles = {Handle{Corner::top_left, {}}, Handle{Corner::top_right, {}}};
  scene.duration_s = kCourse_s;
  return scene;
}

TimedIterations timed(const Pilot& pilot) {
  return {pilot.size, pilot.course.empty() ? 0.0 : pilot.course.back().iterations, pilot.wall_s, pilot.factor_s};
}

bool ascends(const RunCourse& course) {
  RunPoint before;
  for (const RunPoint& point : course) {
    if (!(point.t > before.t && point.steps >= before.steps && point.iterations >= before.iterations)) return false;
    before = point;
  }
  return !course.empty() && std::isfinite(before.t + before.steps + before.iterations);
}

}  // namespace

Calibration calibrate(const Clock& clock) {
  Scene scene = hanging_swatch(kSmallest);
  const Pilot fixed = run_pilot(scene, {kSlowest_s, {}}, clock);
  scene.numerics = AccuracyNumerics{kPilotTolerance_m};
  const Pilot accurate = run_pilot(scene, {kSlowest_s, {}}, clock);
  const Pilot large = run_pilot(hanging_swatch(kLargest), {kLargest_s, {}}, clock);
  const TimedIterations samples[] = {timed(fixed), timed(accurate), timed(large)};
  return {fit_cost(samples), large.size, fixed.course, accurate.course};
}

bool is_sound(const Calibration& calibration) {
  const IterationCost& cost = calibration.cost;
  const double each = iteration_s(cost, calibration.sheet);
  return cost.per_nonzero_s >= 0.0 && cost.per_operation_s >= 0.0 && each > 0.0 && std::isfinite(each) &&
         calibration.sheet.dofs > 1 && calibration.sheet.factor.entries > 0.0 && ascends(calibration.fixed) &&
         ascends(calibration.accurate);
}

}  // namespace slipstitch
