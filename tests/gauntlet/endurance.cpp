// SPDX-License-Identifier: MIT
#include "gauntlet/endurance.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

#include "gauntlet/case_parts.h"
#include "sim/prepare.h"

namespace slipstitch::gauntlet {
namespace {

constexpr double kStep_s = 1.0 / 240.0;
constexpr int kToCurl = 480;  // steps in which it takes its shape
constexpr double kLongStep_s = 0.1;
constexpr int kLongSteps = 500, kTimesStopped = 5;  // sliding friction lets go of the last micrometres within minutes
constexpr long kReportEvery = 10000;
constexpr double kStiffSliding = 1e4;  // [N s/m]
constexpr int kCreepingSteps = 24, kStepsBefore = 300;  // the latter long

}  // namespace

RestingSwatch::RestingSwatch(Friction friction) {
  Scene scene = swatch(5, 5);
  if (friction == Friction::off) scene.effects.sliding_friction.reset();
  sim_.emplace(prepare(scene).model);
  advance(kToCurl, kStep_s, {});
  for (int k = 0; k < kTimesStopped; ++k) {
    stop();  // nothing else slows a free body down that turns
    advance(kLongSteps, kLongStep_s, {});
  }
  stop();
  rest_ = sim_->state().q;
  newton_iterations_ = 0;
}

void RestingSwatch::stop() {
  State state = sim_->state();
  state.v.setZero();
  state.p.setZero();
  sim_->restore(state);
}

double RestingSwatch::speed() const {
  double fastest = 0.0;
  for (int n = 0; n < sim_->model().topology.num_nodes; ++n)
    fastest = std::max(fastest, sim_->state().v.segment<3>(3 * n).norm());
  return fastest;
}

double RestingSwatch::distance() const {
  double farthest = 0.0;
  for (int n = 0; n < sim_->model().topology.num_nodes; ++n)
    farthest = std::max(farthest, (sim_->state().q - rest_).segment<3>(3 * n).norm());
  return farthest;
}

void RestingSwatch::advance(long steps, const std::function<void()>& after_step) {
  advance(steps, kStep_s, after_step);
}

void RestingSwatch::advance(long steps, double step_s, const std::function<void()>& after_step) {
  const FixedNumerics numerics;
  for (long k = 0; k < steps; ++k) {
    const StepReport report = sim_->step(step_s, numerics, {});
    if (!report.accepted) throw std::runtime_error("a step from rest does not converge");
    newton_iterations_ += report.newton.iterations;
    if (after_step) after_step();
  }
}

void RestingSwatch::kick(double way) {
  State state = sim_->state();
  for (const int node : sim_->model().topology.stitches.back().node) state.q[3 * node + 2] += way;
  sim_->restore(state);
}

double RestingSwatch::energy() {
  double sum = 0.0;
  for (const auto& [term, energy] : sim_->energies()) sum += energy;
  return sum;
}

Rest rest(long steps, const std::function<void(long done)>& on_progress) {
  RestingSwatch swatch(Friction::on);
  Rest result{steps, 0, 0.0, 0.0};
  long done = 0;
  swatch.advance(steps, [&] {
    result.farthest_m = std::max(result.farthest_m, swatch.distance());
    result.fastest_m_per_s = std::max(result.fastest_m_per_s, swatch.speed());
    if (++done % kReportEvery == 0 && on_progress) on_progress(done);
  });
  result.newton_iterations = swatch.newton_iterations();
  return result;
}

std::string rest_text(const Rest& found) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(),
                "5 x 5 stitches, %ld steps of rest: %.1e m from their place and %.1e m/s at most, %ld Newton iterations\n",
                found.steps, found.farthest_m, found.fastest_m_per_s, found.newton_iterations);
  return text.data();
}

Crept crept(double tolerance_share) {
  Scene scene = swatch(5, 5);
  hang(scene);
  scene.effects.damping->sliding_ns_per_m = kStiffSliding;
  scene.loads = {{Edge::bottom, {0, -0.05, 0}}};
  Simulation sim(prepare(scene).model);
  FixedNumerics numerics;
  numerics.velocity_tolerance_m_per_s *= tolerance_share;
  const Topology& topology = sim.model().topology;
  const auto advance = [&](double step_s) {
    if (!sim.step(step_s, numerics, {}).accepted) throw std::runtime_error("a creeping step does not converge");
  };
  for (int k = 0; k < kToCurl; ++k) advance(kStep_s);
  for (int k = 0; k < kStepsBefore; ++k) advance(kLongStep_s);
  const VecX before = sim.state().q.tail(topology.num_visits());
  Crept found;
  for (int k = 0; k < kCreepingSteps; ++k) {
    advance(kStep_s);
    for (int n = 0; n < topology.num_nodes; ++n)
      found.fastest_m_per_s = std::max(found.fastest_m_per_s, sim.state().v.segment<3>(3 * n).norm());
  }
  found.mean_m = (sim.state().q.tail(topology.num_visits()) - before).cwiseAbs().mean();
  return found;
}

}  // namespace slipstitch::gauntlet
