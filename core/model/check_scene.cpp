// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/check_parts.h"

namespace slipstitch {
namespace {

void check_material(const YarnMaterial& yarn, Checker& check) {
  check.positive("yarn.radius_m", yarn.radius_m);
  check.positive("yarn.linear_density_kg_per_m", yarn.linear_density_kg_per_m);
  check.positive("yarn.stretch_n", yarn.stretch_n);
  check.positive("yarn.bending_nm2", yarn.bending_nm2);
}

// Names travel in every answer about a job and are shown in terminals.
void check_name(const std::string& name, Checker& check) {
  constexpr std::size_t kLongestName = 200;
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (name.size() > kLongestName) check.fail("name", std::to_string(name.size()) + " bytes", "at most 200 bytes");
  if (std::any_of(name.begin(), name.end(), control))
    check.fail("name", "a text with control characters", "printable characters");
}

void check_time(const Scene& scene, const SceneLimits& limits, Checker& check) {
  check.not_negative("duration_s", scene.duration_s);
  check.positive("frames_per_s", scene.frames_per_s);
  if (!std::isfinite(scene.duration_s) || !std::isfinite(scene.frames_per_s)) return;
  const double frames = scene.duration_s * scene.frames_per_s + 1.0;
  if (scene.duration_s > 0.0 && scene.frames_per_s > 0.0 && frames > limits.max_frames) {
    const std::string count = std::isfinite(frames) ? number_text(std::floor(frames)) : "too many";
    check.too_big("frames_per_s", count, limits.max_frames, "frames");
  }
}

}  // namespace

void check_numerics(const Scene& scene, const SceneLimits& limits, Checker& check) {
  if (const auto* accuracy = std::get_if<AccuracyNumerics>(&scene.numerics)) {
    const double least = AccuracyNumerics::kLeastTolerance_m;
    if (!(std::isfinite(accuracy->tolerance_m) && accuracy->tolerance_m >= least))
      check.fail("accuracy.tolerance_m", number_text(accuracy->tolerance_m),
                 "a finite number >= " + number_text(least));
    return;
  }
  if (const auto* budget = std::get_if<BudgetNumerics>(&scene.numerics))
    return check.positive("accuracy.budget_s", budget->budget_s);
  const auto& fixed = std::get<FixedNumerics>(scene.numerics);
  check.positive("fixed.time_step_s", fixed.time_step_s);
  check.positive("fixed.velocity_tolerance_m_per_s", fixed.velocity_tolerance_m_per_s);
  check.positive("fixed.force_tolerance_n", fixed.force_tolerance_n);
  check.positive("fixed.smallest_step_s", fixed.smallest_step_s);
  const bool too_many_frames = !(scene.duration_s * scene.frames_per_s <= limits.max_frames);  // said already
  if (!too_many_frames && fixed.time_step_s > 0.0 && scene.duration_s / fixed.time_step_s > limits.max_steps) {
    check.fail("fixed.time_step_s", number_text(fixed.time_step_s),
               "at least " + number_text(scene.duration_s / limits.max_steps) + ", that is, at most " +
                   number_text(limits.max_steps) + " steps");
  }
  if (std::isfinite(fixed.smallest_step_s) && fixed.smallest_step_s > fixed.time_step_s && fixed.time_step_s > 0.0) {
    check.fail("fixed.smallest_step_s", number_text(fixed.smallest_step_s),
               "at most fixed.time_step_s, " + number_text(fixed.time_step_s));
  }
  if (fixed.max_newton_iterations < 1) {
    check.fail("fixed.max_newton_iterations", std::to_string(fixed.max_newton_iterations), "at least 1");
  }
}

Issues check(const Scene& scene, const SceneLimits& limits) {
  Issues issues;
  Checker checker(issues);
  if (!scene.knit && scene.yarns.empty()) checker.fail("", "neither a knit nor yarns", "a knit, or at least one yarn");
  if (scene.knit) check_knit(*scene.knit, limits, checker);
  check_yarns(scene, limits, checker);
  check_name(scene.name, checker);
  check_material(scene.yarn, checker);
  check_effects(scene.effects, checker);
  if (!issues.any_too_big()) check_actions(scene, checker);  // counts of a scene over its limits could overflow
  check_time(scene, limits, checker);
  check_numerics(scene, limits, checker);
  return issues;
}

}  // namespace slipstitch
