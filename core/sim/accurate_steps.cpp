// SPDX-License-Identifier: MIT
// Steps as long as a tolerance on positions, or a wall time, allows. The run goes in pairs of steps of h; a companion
// that knows nothing of it goes in single ones of 2h. Their distance tells how far the run is from the exact motion,
// whatever bends, slides or touches on the way [Richardson; Hairer, Norsett and Wanner 1993, II.4]; how far two steps
// part from what their own velocities make of them tells how long the next ones may be.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/dof_map.h"
#include "sim/longest_step.h"
#include "sim/pair_goal.h"
#include "sim/step_control.h"

namespace slipstitch {
namespace {

constexpr double kFirstSpeed = 1.0;  // of yarn that would go the tolerance in the first pair [m/s]
constexpr double kShrink = 0.25, kGrow = 4.0, kCaution = 0.85;  // of a pair from one to the next
constexpr double kGrowth = 1.5;      // of the distance to the companion in a pair, that is no error of the pair's own
constexpr double kAccept = 2.0;      // times the step's tolerance, that a pair is not done again for
constexpr double kSolveShare = 0.1;  // of a pair's tolerance, for one solve
constexpr double kSmallestStep_s = 1e-7;
constexpr double kSameTime = 1e-9;        // of the duration, and less
constexpr double kEven = 1.01;            // pairs are a little longer than wanted, where that makes their number whole
constexpr double kSmallestPair_s = 4e-7;  // that is done again for its error; evened out it is at least half as long
constexpr double kLeastVelocityTolerance = 1e-9;  // [m/s]

/// Times at which what is scripted turns a corner, ascending [s].
std::vector<double> corners(const Model& model) {
  std::vector<double> times;
  for (const ScriptedNodes& handle : model.handles)
    for (const Keyframe& key : handle.motion) times.push_back(key.t);
  if (model.effects.colliders)
    for (const Collider& collider : model.effects.colliders->colliders)
      for (const Keyframe& key : collider.motion) times.push_back(key.t);
  if (model.effects.shrinkage)
    for (const LengthKeyframe& key : model.effects.shrinkage->keyframes) times.push_back(key.t);
  std::sort(times.begin(), times.end());
  return times;
}

/// Second order holds where nothing switches: what sticks, slips, touches or yields between two steps costs one.
double order(const Model& model) {
  const Effects& on = model.effects;
  const bool switches = on.sliding_friction || on.colliders || on.self_collision || on.plasticity;
  return on.inertia && !switches ? 2.0 : 1.0;
}

/// q at t of the motion with these states, by their velocities.
VecX between(double t, const State& a, const State& b) {
  const double h = b.t - a.t, s = (t - a.t) / h, r = 1.0 - s;
  return r * r * (1.0 + 2.0 * s) * a.q + s * s * (3.0 - 2.0 * s) * b.q + h * s * r * (r * a.v - s * b.v);
}

VecX between(double t, const State& a, const State& middle, const State& b) {
  return t < middle.t ? between(t, a, middle) : between(t, middle, b);
}

class AccurateSteps final : public StepControl {
 public:
  AccurateSteps(std::unique_ptr<PairGoal> goal, const Scene& scene, const Simulation& sim,
                std::unique_ptr<LinearSolver> solver)
      : goal_(std::move(goal)),
        duration_(scene.duration_s),
        frames_per_s_(scene.frames_per_s),
        order_(order(sim.model())),
        power_(sim.quasi_static() ? 2.0 : 3.0),
        corners_(corners(sim.model())),
        companion_(sim.model(), std::move(solver)),
        next_pair_(goal_->tolerance_m() / kFirstSpeed) {
    numerics_.integrator = Integrator::sdirk2;
    numerics_.smallest_step_s = kSmallestStep_s;
    aid_.motion_first = aid_.foresee = true;
    const DofMap map = make_dof_map(sim.model());
    for (int n = 0; n < sim.model().topology.num_nodes; ++n)
      if (map.dof_of(3 * n) >= 0) free_nodes_.push_back(n);
  }

  NewtonReport try_out(Simulation& sim, const ShouldStop& should_stop, const std::function<void()>& on_pair) override {
    NewtonReport counts;
    const State start = sim.state();
    const ShouldStop stop = [&] { return !goal_->on_trial() || (should_stop && should_stop()); };
    for (int frame = 1; !stop() && duration_ - sim.state().t > kSameTime * duration_;) {
      const double end = std::min(frame / frames_per_s_, duration_);
      const Attempt pair = attempt(sim, end, stop);
      add_counts(pair.report.newton, counts);
      if (pair.steps == 0 && wanted_step() < smallest_step()) break;
      if (end - sim.state().t <= kSameTime * duration_) ++frame;
      on_pair();
    }
    sim.restore(start);
    companion_.restore(start);
    error_ = {};
    goal_->end_trial();
    next_pair_ = goal_->tolerance_m() / kFirstSpeed;
    return counts;
  }

  Attempt attempt(Simulation& sim, double end, const ShouldStop& should_stop) override {
    const double remaining = next_corner(sim.state().t, end) - sim.state().t;
    const double wanted = longest_step(sim, std::min(next_pair_, remaining));
    const double pair = remaining / std::ceil(remaining / wanted - 1e-6);
    const State begin = sim.state(), companion_begin = companion_.state();
    const double known = distance(sim);
    Attempt result = try_pair(sim, 0.5 * pair, should_stop);
    double error = 0.0;
    if (result.steps > 0) {
      error = error_of_pair(begin, sim, known);
      if (!good_enough(pair, error)) result.steps = 0;
    }
    if (result.steps > 0) {
      learn(sim, {sim.state().t, pair, error * goal_->pair_tolerance_m(), 0.0}, end);
    } else {
      sim.restore(begin);
      companion_.restore(companion_begin);
    }
    return result;
  }
  double wanted_step() const override { return 0.5 * next_pair_; }
  double smallest_step() const override { return numerics_.smallest_step_s; }
  std::optional<ErrorEstimate> error() const override { return error_; }
  const Simulation* companion() const override { return &companion_; }
  std::optional<BudgetReport> budget() const override { return goal_->budget(); }

 private:
  double next_corner(double t, double end) const {
    const auto next = std::upper_bound(corners_.begin(), corners_.end(), t + 1e-9 * (end - t));
    return next == corners_.end() ? end : std::min(*next, end);
  }

  /// Two steps of h, and one of 2h by the companion.
  Attempt try_pair(Simulation& sim, double h, const ShouldStop& should_stop) {
    numerics_.velocity_tolerance_m_per_s =
        std::max(kSolveShare * goal_->pair_tolerance_m() / h, kLeastVelocityTolerance);
    Attempt result;
    result.h = h;
    const auto step = [&](Simulation& which, double length) {
      const NewtonReport before = result.report.newton;
      result.report = which.step(length, numerics_, should_stop, aid_);
      add_counts(before, result.report.newton);
      return result.report.accepted;
    };
    const State begin = sim.state();
    aid_.expected = {};
    bool done = step(sim, h);
    middle_ = sim.state();
    done = done && step(sim, h);
    if (!sim.quasi_static()) {
      const VecX apart = companion_.state().q - begin.q;
      aid_.expected = [&, apart](double t) -> VecX { return apart + between(t, begin, middle_, sim.state()); };
    }
    done = done && step(companion_, 2.0 * h);
    result.steps = done ? 2 : 0;
    if (!done) next_pair_ = h;
    return result;
  }

  /// Over what a pair may have.
  double error_of_pair(const State& begin, const Simulation& sim, double distance_before) const {
    const double tolerance = goal_->pair_tolerance_m();
    const double parted = std::max(0.0, distance(sim) - kGrowth * distance_before) / tolerance;
    return sim.quasi_static() ? parted : std::max(parted, defect(begin, middle_, sim.state()) / tolerance);
  }

  /// Also chooses the next pair.
  bool good_enough(double pair, double error) {
    const double change = kCaution * std::pow(std::max(error, 1e-300), -1.0 / power_);
    next_pair_ = std::max(pair * std::clamp(change, kShrink, kGrow), kSmallestPair_s);
    return error <= kAccept || pair <= kEven * kSmallestPair_s;
  }

  template <class F>
  double farthest(F&& of_node) const {
    double most = 0.0;
    for (const int n : free_nodes_) most = std::max(most, of_node(n).norm());
    return most;
  }

  double distance(const Simulation& sim) const {
    return farthest([&](int n) -> Vec3 { return (sim.state().q - companion_.state().q).segment<3>(3 * n); });
  }

  /// Of two equal steps from what Simpson's rule makes of the velocities at their ends.
  double defect(const State& a, const State& m, const State& b) const {
    const double sixth = (b.t - a.t) / 6.0;
    return farthest([&](int n) -> Vec3 {
      const auto at = [n](const VecX& x) { return x.segment<3>(3 * n); };
      return at(b.q) - at(a.q) - sixth * (at(a.v) + 4.0 * at(m.v) + at(b.v));
    });
  }

  /// `done`: but for the run's error.
  void learn(const Simulation& sim, PairDone done, double end) {
    error_.position_m = done.run_error_m = distance(sim) / (std::pow(2.0, order_) - 1.0);
    const double tolerance = goal_->pair_tolerance_m();
    goal_->learn(done);
    if (goal_->jumps()) next_pair_ *= std::min(1.0, std::sqrt(goal_->pair_tolerance_m() / tolerance));
    if (sim.state().t < end * (1.0 - 1e-12)) return;
    error_.max_position_m = std::max(error_.max_position_m, error_.position_m);
    if (error_.position_m <= goal_->lost_m()) return;
    if (!error_.lost_at_s) error_.lost_at_s = sim.state().t;
    companion_.restore(sim.state());
  }

  const std::unique_ptr<PairGoal> goal_;
  const double duration_, frames_per_s_;
  const double order_, power_;  // of the run's error in the step, and of a pair's
  const std::vector<double> corners_;
  std::vector<int> free_nodes_;
  Simulation companion_;
  FixedNumerics numerics_;
  StepAid aid_;
  State middle_;
  double next_pair_;  // two steps together [s]
  ErrorEstimate error_;
};

}  // namespace

std::unique_ptr<StepControl> make_accurate_steps(std::unique_ptr<PairGoal> goal, const Scene& scene,
                                                 const Simulation& sim, std::unique_ptr<LinearSolver> solver) {
  return std::make_unique<AccurateSteps>(std::move(goal), scene, sim, std::move(solver));
}

}  // namespace slipstitch
