// SPDX-License-Identifier: MIT
#include "swatch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/knit_topology.h"
#include "sim/monitor.h"
#include "sim/simulation.h"

namespace slipstitch::test {
namespace {

// Stockinette swatches of the demo yarn need 150 to 600 iterations to roll up.
constexpr int kMaxIterations = 4000;

double contact_length(const Topology& topology) {
  const StitchContact& contact = topology.contacts.front();
  return rest_length(topology, std::min(contact.u_visit[0], contact.u_visit[1]));
}

Vec3 mean_of_nodes(const Stitch& stitch, const VecX& q) {
  Vec3 sum = Vec3::Zero();
  for (const int node : stitch.node) sum += q.segment<3>(3 * node);
  return sum / static_cast<double>(stitch.node.size());
}

std::vector<double> faded_by_wale(const Simulation& sim) {
  const Topology& topology = sim.model().topology;
  const auto& wraps = std::get<Wrapping>(sim.forces());
  const auto wales = static_cast<std::size_t>(topology.num_wales);
  std::vector<double> faded(wales, 0.0), all(wales, 0.0);
  for (int k = 0; k < wraps.size(); ++k) {
    const int stitch = topology.contacts[static_cast<std::size_t>(wraps.contact(k))].stitch;
    if (stitch < 0) continue;
    const Stitch& s = topology.stitches[static_cast<std::size_t>(stitch)];
    if (s.course < 3 || s.course > topology.num_courses - 2) continue;
    Vec<12> x;
    for (int i = 0; i < 12; ++i) x[i] = sim.state().q[wraps.coords(k)[static_cast<std::size_t>(i)]];
    const auto wale = static_cast<std::size_t>(s.wale - 1);
    all[wale] += 1.0;
    faded[wale] += wrap_fade(x, wraps.wrap(k).L) < 1.0 ? 1.0 : 0.0;
  }
  for (std::size_t w = 0; w < wales; ++w) faded[w] = all[w] > 0.0 ? faded[w] / all[w] : 0.0;
  return faded;
}

/// Means over `group` consecutive courses.
Swatch grouped(const Swatch& swatch, int group) {
  Swatch result;
  result.courses = swatch.courses / group;
  result.wales = swatch.wales;
  for (int c = 1; c <= result.courses; ++c) {
    for (int w = 1; w <= swatch.wales; ++w) {
      Vec3 sum = Vec3::Zero();
      for (int k = 0; k < group; ++k) sum += swatch.centre((c - 1) * group + 1 + k, w);
      result.centres.push_back(sum / group);
    }
  }
  return result;
}

Vec3 right_side(const Swatch& s, int c, int w) {
  const Vec3 course = s.centre(c, std::min(s.wales, w + 1)) - s.centre(c, std::max(1, w - 1));
  const Vec3 wale = s.centre(std::min(s.courses, c + 1), w) - s.centre(std::max(1, c - 1), w);
  return course.cross(wale).normalized();
}

double curvature(const Vec3& before, const Vec3& here, const Vec3& after, const Vec3& normal) {
  const Vec3 a = here - before, b = after - here;
  return (b.normalized() - a.normalized()).dot(normal) / (0.5 * (a.norm() + b.norm()));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_curvature(const Swatch& s, int dc, int dw) {
  std::vector<double> values;
  for (int c = 1 + dc; c <= s.courses - dc; ++c) {
    for (int w = 1 + dw; w <= s.wales - dw; ++w) {
      values.push_back(
          curvature(s.centre(c - dc, w - dw), s.centre(c, w), s.centre(c + dc, w + dw), right_side(s, c, w)));
    }
  }
  return median(std::move(values));
}

}  // namespace

Effects knit_effects() {
  Effects effects;
  effects.stretch.emplace();
  effects.bending.emplace();
  effects.bending_jamming.emplace();
  effects.wrapping.emplace();
  return effects;
}

Pattern pattern_of(const SwatchSpec& spec) {
  Issues issues;
  const PresetSpec preset{spec.preset, spec.courses, spec.wales, spec.rib, spec.rib};
  const Pattern pattern = pattern_from_preset(preset, false, "preset", issues);
  EXPECT_TRUE(issues.empty());
  return pattern;
}

RelaxedRepeat repeat_of(const SwatchSpec& spec) {
  Knit knit;
  knit.pattern = pattern_of(spec);
  knit.gauge = {2.9e-3, 2.03e-3, {}};
  const RelaxedRepeat repeat = relax_repeat(knit, YarnMaterial{}, spec.effects);
  EXPECT_EQ(repeat.newton.status, NewtonStatus::converged) << to_string(repeat.newton.status);
  return repeat;
}

double course_period(const SwatchSpec& spec) {
  const RestCell cell = repeat_of(spec).cell;
  return cell.period_course.x() / cell.repeat.wales;
}

Model flat_swatch(const SwatchSpec& spec) {
  SwatchSpec rest = spec;
  rest.effects = knit_effects();
  Knit knit;
  knit.pattern = pattern_of(spec);
  knit.noise_m = 2e-6 * spec.seed;
  knit.noise_seed = static_cast<std::uint64_t>(spec.seed);
  PlacedTopology placed = build_knit(knit, repeat_of(rest).cell);
  Model model;
  model.topology = std::move(placed.topology);
  model.effects = spec.effects;
  model.start_v = VecX::Zero(placed.q.size());
  model.start_q = std::move(placed.q);
  return model;
}

Swatch bring_to_rest(Model model) {
  FixedNumerics numerics;
  const double L = contact_length(model.topology);
  numerics.force_tolerance_n = 1e-6 * model.yarn.bending_nm2 / (L * L);
  numerics.max_newton_iterations = kMaxIterations;
  Simulation sim(std::move(model));
  const StepReport report = sim.step(1.0, numerics, {});
  EXPECT_TRUE(report.accepted) << to_string(report.newton.status);
  EXPECT_LE(report.residual, numerics.force_tolerance_n);

  Swatch swatch;
  const Topology& topology = sim.model().topology;
  swatch.courses = topology.num_courses;
  swatch.wales = topology.num_wales;
  swatch.q = sim.state().q;
  for (const Stitch& stitch : topology.stitches) swatch.centres.push_back(mean_of_nodes(stitch, swatch.q));
  Monitor monitor(sim);
  monitor.observe(sim, report.residual);
  monitor.report(sim, swatch.measured);
  swatch.faded_by_wale = faded_by_wale(sim);
  return swatch;
}

Swatch swatch_at_rest(const SwatchSpec& spec) { return bring_to_rest(flat_swatch(spec)); }

double curvature_across_wales(const Swatch& swatch, int group) {
  return median_curvature(grouped(swatch, group), 0, 1);
}

double curvature_along_wales(const Swatch& swatch, int group) { return median_curvature(grouped(swatch, group), 1, 0); }

double two_stitch_distance(const Swatch& swatch) {
  double sum = 0.0;
  int count = 0;
  for (int c = 2; c < swatch.courses; ++c) {
    for (int w = 2; w + 2 < swatch.wales; ++w, ++count) sum += (swatch.centre(c, w + 2) - swatch.centre(c, w)).norm();
  }
  return sum / count;
}

}  // namespace slipstitch::test
