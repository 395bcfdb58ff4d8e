// SPDX-License-Identifier: MIT
#include "study/rungs.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "sim/run.h"
#include "study/three_digits.h"

namespace slipstitch {
namespace {

struct Method {
  Integrator integrator;
  const char* name;
};
constexpr std::array kMethods{Method{Integrator::linearised_euler, "LINEARISED_EULER"},
                              Method{Integrator::implicit_euler, "IMPLICIT_EULER"}, Method{Integrator::bdf2, "BDF2"},
                              Method{Integrator::sdirk2, "SDIRK2"},
                              Method{Integrator::implicit_midpoint, "IMPLICIT_MIDPOINT"}};
static_assert(std::string_view(kMethods[0].name) == kBaselineMethod);

constexpr double kLargestStep_s = 1.0 / 60, kSmallestStep_s = 0.25e-3;
constexpr std::size_t kFewestSteps = 3, kMostSteps = 12, kQuickSteps = 4;  // of one method
constexpr std::array kTolerances_m{1e-2, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5};
constexpr std::size_t kQuickTolerances = 4;
constexpr std::array kForceTolerances{1000.0, 30.0, 1.0};  // times the scene's, of static scenes
constexpr std::size_t kStaticSteps = 4, kQuickStaticSteps = 2;

std::string step_text(double seconds) {
  return seconds < 0.9995 ? three_digits(1e3 * seconds) + " ms" : three_digits(seconds) + " s";
}

std::string force_text(double newtons) {
  return newtons < 0.9995e-6 ? three_digits(1e9 * newtons) + " nN" : three_digits(1e6 * newtons) + " uN";
}

/// Halves of what splits the time from frame to frame evenly.
std::vector<double> steps_of(const Scene& scene) {
  const double frame = 1.0 / scene.frames_per_s;
  const double longest = std::max(kLargestStep_s, fixed_numerics(scene).time_step_s);
  double step = frame / least_steps_per_frame(scene.frames_per_s, longest);
  std::vector<double> steps;
  for (; step > kSmallestStep_s * (1.0 - 1e-6) || steps.size() < kFewestSteps; step *= 0.5) steps.push_back(step);
  return steps;
}

Rung fixed_rung(const Scene& scene, const Method& method, double step) {
  FixedNumerics numerics = fixed_numerics(scene);
  numerics.integrator = method.integrator;
  numerics.time_step_s = step;
  numerics.smallest_step_s = std::min(numerics.smallest_step_s, step);
  return {method.name, step_text(step), step, numerics};
}

Rung static_rung(const Scene& scene, double step, double factor) {
  FixedNumerics numerics = fixed_numerics(scene);
  numerics.time_step_s = step;
  numerics.smallest_step_s = std::min(numerics.smallest_step_s, step);
  numerics.force_tolerance_n *= factor;
  return {std::string(kStaticMethod), step_text(step) + " " + force_text(numerics.force_tolerance_n), step, numerics};
}

Rung accurate_rung(double tolerance) {
  AccuracyNumerics numerics;
  numerics.tolerance_m = tolerance;
  return {std::string(kAccuracyMethod), three_digits(1e3 * tolerance) + " mm", tolerance, numerics};
}

}  // namespace

FixedNumerics fixed_numerics(const Scene& scene) {
  const auto* fixed = std::get_if<FixedNumerics>(&scene.numerics);
  return fixed != nullptr ? *fixed : FixedNumerics{};
}

std::vector<Rung> all_rungs(const Scene& scene, bool quick) {
  const bool moves = scene.effects.inertia.has_value();
  const std::size_t most_steps =
      moves ? (quick ? kQuickSteps : kMostSteps) : (quick ? kQuickStaticSteps : kStaticSteps);
  const std::size_t num_tolerances = quick ? kQuickTolerances : kTolerances_m.size();
  const std::vector<double> steps = steps_of(scene);
  const std::size_t num_steps = std::min(steps.size(), most_steps);
  std::vector<Rung> rungs;
  for (std::size_t k = 0; k < std::max(num_steps, num_tolerances); ++k) {
    if (k < num_steps && moves)
      for (const Method& method : kMethods) rungs.push_back(fixed_rung(scene, method, steps[k]));
    if (k < num_steps && !moves)
      for (const double factor : kForceTolerances) rungs.push_back(static_rung(scene, steps[k], factor));
    if (k < num_tolerances) rungs.push_back(accurate_rung(kTolerances_m[k]));
  }
  return rungs;
}

std::vector<Rung> ladder(const Scene& scene, bool quick) {
  std::vector<Rung> rungs = all_rungs(scene, quick);
  std::erase_if(rungs, [&](const Rung& rung) { return !check(with_rung(scene, rung)).empty(); });
  return rungs;
}

std::string rung_name(const Rung& rung) { return rung.method + " " + rung.label; }

Scene with_rung(const Scene& scene, const Rung& rung) {
  Scene variant = scene;
  std::visit([&](const auto& numerics) { variant.numerics = numerics; }, rung.numerics);
  return variant;
}

Rung refined(const Rung& rung, double step_factor, double tolerance_factor) {
  constexpr double kLeastVelocityTolerance = 1e-9;  // [m/s], near to what rounding leaves
  Rung finer = rung;
  auto& numerics = std::get<FixedNumerics>(finer.numerics);
  numerics.time_step_s *= step_factor;
  numerics.smallest_step_s = std::min(numerics.smallest_step_s, numerics.time_step_s);
  numerics.velocity_tolerance_m_per_s =
      std::min(numerics.velocity_tolerance_m_per_s,
               std::max(kLeastVelocityTolerance, tolerance_factor * numerics.velocity_tolerance_m_per_s));
  numerics.force_tolerance_n *= tolerance_factor;
  finer.size = numerics.time_step_s;
  finer.label = step_text(finer.size) + ", reference";
  return finer;
}

std::string exact_text(const Rung& rung) {
  std::array<char, 256> text{};
  if (const auto* accuracy = std::get_if<AccuracyNumerics>(&rung.numerics)) {
    std::snprintf(text.data(), text.size(), "tolerance %.17g", accuracy->tolerance_m);
  } else {
    const auto& fixed = std::get<FixedNumerics>(rung.numerics);
    std::snprintf(text.data(), text.size(), "step %.17g velocity %.17g force %.17g newton %d smallest %.17g",
                  fixed.time_step_s, fixed.velocity_tolerance_m_per_s, fixed.force_tolerance_n,
                  fixed.max_newton_iterations, fixed.smallest_step_s);
  }
  return rung.method + " " + text.data();
}

}  // namespace slipstitch
