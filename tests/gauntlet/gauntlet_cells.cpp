// SPDX-License-Identifier: MIT
#include "gauntlet/gauntlet_cells.h"

#include <array>

#include "gauntlet/covering.h"
#include "model/check_values.h"

namespace slipstitch::gauntlet {
namespace {

// Of the cases' own 1/240 s: from 1e-5 s to a tenth of a second.
constexpr std::array kSteps{1.0, 2.4e-3, 0.1, 4.0, 24.0};
constexpr std::array kStiffnesses{1.0, 1e-3, 0.1, 1e3};

constexpr NaiveVariant kVariants[] = {
    {"unsigned arccos", &Naive::unsigned_angle},
    {"unfaded wraps", &Naive::unfaded_wraps},
    {"unfiltered steps", &Naive::unfiltered_steps},
    {"unprojected Hessians", &Naive::unprojected_hessian},
    {"explicit friction", &Naive::explicit_friction},
    {"inertia without velocity terms", &Naive::no_velocity_terms},
    {"linearised one-solve integrator", nullptr},
};

}  // namespace

std::vector<Cell> gauntlet_cells(const std::vector<GauntletCase>& cases) {
  std::vector<Cell> cells;
  for (int i = 0; i < static_cast<int>(cases.size()); ++i) cells.push_back({i, {}});
  const std::vector<int> levels{static_cast<int>(cases.size()), static_cast<int>(kSteps.size()),
                                static_cast<int>(kStiffnesses.size()), 2, 2};
  for (const std::vector<int>& row : pairwise_covering(levels)) {
    Settings settings;
    settings.step_factor = kSteps[static_cast<std::size_t>(row[1])];
    settings.stiffness_factor = kStiffnesses[static_cast<std::size_t>(row[2])];
    settings.quasi_static = row[3] == 1;
    settings.simplicial = row[4] == 1;
    if (settings_text(settings) != settings_text({})) cells.push_back({row[0], settings});
  }
  return cells;
}

std::span<const NaiveVariant> naive_variants() { return kVariants; }

std::vector<Cell> naive_cells(const std::vector<GauntletCase>& cases) {
  std::vector<Cell> cells;
  for (const NaiveVariant& variant : kVariants)
    for (int i = 0; i < static_cast<int>(cases.size()); ++i) {
      cells.push_back({i, {}});
      make_naive(variant, cells.back().settings);
    }
  return cells;
}

void make_naive(const NaiveVariant& variant, Settings& settings) {
  if (variant.set == nullptr) {
    settings.integrator = Integrator::linearised_euler;
  } else {
    settings.naive.*variant.set = true;
  }
}

std::string naive_name(const Settings& settings) {
  for (const NaiveVariant& variant : kVariants) {
    const bool linearised = settings.integrator == Integrator::linearised_euler;
    if (variant.set == nullptr ? linearised : settings.naive.*variant.set) return variant.name;
  }
  return {};
}

std::string settings_text(const Settings& settings) {
  std::string text;
  const auto add = [&](bool holds, const std::string& what) {
    if (holds) text += (text.empty() ? "" : ", ") + what;
  };
  add(settings.step_factor != 1.0, "step x" + number_text(settings.step_factor));
  add(settings.stiffness_factor != 1.0, "stiffness x" + number_text(settings.stiffness_factor));
  add(settings.quasi_static, "static");
  add(settings.simplicial, "simplicial");
  const std::string naive = naive_name(settings);
  add(!naive.empty(), naive);
  return text.empty() ? "as it is" : text;
}

}  // namespace slipstitch::gauntlet
