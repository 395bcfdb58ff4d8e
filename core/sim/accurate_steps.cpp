// SPDX-License-Identifier: MIT
// Steps as long as a tolerance on positions allows. The run goes in pairs of steps of h; a companion that knows nothing
// of it goes in single ones of 2h. Their distance tells how far the run is from the exact motion, whatever bends,
// slides or touches on the way [Richardson; Hairer, Norsett and Wanner 1993, II.4]; how far two steps part from what
// their own velocities make of them tells how long the next ones may be.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/dof_map.h"
#include "sim/longest_step.h"
#include "sim/step_control.h"

namespace slipstitch {
namespace {

constexpr double kFirstSpeed = 1.0;  // of yarn that would go the tolerance in the first pair [m/s]
constexpr double kShrink = 0.25, kGrow = 4.0, kCaution = 0.85;  // of a pair from one to the next
constexpr double kGrowth = 1.5;       // of the distance to the companion in a pair, that is no error of the pair's own
constexpr double kAccept = 2.0;       // times the step's tolerance, that a pair is not done again for
constexpr double kMemory = 0.1;       // of the duration, for peaks of the error,
constexpr double kMemoryPairs = 20.0;  // but not of more pairs
constexpr double kWantedAtEnd = 0.35;  // of the tolerance, that the error is steered to
constexpr double kWantedAtStart = 0.2;                                 // of that
constexpr double kShare = 0.05, kLeastShare = 2e-3, kMostShare = 0.1;  // of the tolerance, for one pair
constexpr double kSolveShare = 0.1;                                    // of that, for one solve
constexpr double kSmallestStep_s = 1e-7;
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
  AccurateSteps(double tolerance_m, double duration_s, const Simulation& sim, std::unique_ptr<LinearSolver> solver)
      : tolerance_(tolerance_m),
        duration_(duration_s),
        order_(order(sim.model())),
        power_(sim.quasi_static() ? 2.0 : 3.0),
        corners_(corners(sim.model())),
        companion_(sim.model(), std::move(solver)) {
    numerics_.integrator = Integrator::sdirk2;
    numerics_.smallest_step_s = kSmallestStep_s;
    aid_.motion_first = aid_.foresee = true;
    const DofMap map = make_dof_map(sim.model());
    for (int n = 0; n < sim.model().topology.num_nodes; ++n)
      if (map.dof_of(3 * n) >= 0) free_nodes_.push_back(n);
  }

  Attempt attempt(Simulation& sim, double end, const ShouldStop& should_stop) override {
    const double remaining = next_corner(sim.state().t, end) - sim.state().t;
    const double wanted = longest_step(sim, std::min(next_pair_, remaining));
    const double pair = remaining / std::ceil(remaining / wanted - 1e-6);
    const State begin = sim.state(), companion_begin = companion_.state();
    const double known = distance(sim);
    Attempt result = try_pair(sim, 0.5 * pair, should_stop);
    if (result.steps > 0 && !good_enough(pair, error_of_pair(begin, sim, known))) result.steps = 0;
    if (result.steps > 0) {
      learn(sim, pair, end);
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

 private:
  double next_corner(double t, double end) const {
    const auto next = std::upper_bound(corners_.begin(), corners_.end(), t + 1e-9 * (end - t));
    return next == corners_.end() ? end : std::min(*next, end);
  }

  /// Two steps of h, and one of 2h by the companion.
  Attempt try_pair(Simulation& sim, double h, const ShouldStop& should_stop) {
    numerics_.velocity_tolerance_m_per_s = std::max(kSolveShare * pair_tolerance_ / h, kLeastVelocityTolerance);
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
    const double parted = std::max(0.0, distance(sim) - kGrowth * distance_before) / pair_tolerance_;
    return sim.quasi_static() ? parted : std::max(parted, defect(begin, middle_, sim.state()) / pair_tolerance_);
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

  void learn(const Simulation& sim, double passed, double end) {
    error_.position_m = distance(sim) / (std::pow(2.0, order_) - 1.0);
    const double way = kWantedAtStart + (1.0 - kWantedAtStart) * sim.state().t / duration_;
    const double wanted = kWantedAtEnd * tolerance_ * way;
    peak_ =
        std::max(error_.position_m, peak_ * std::exp(-std::max(passed / (kMemory * duration_), 1.0 / kMemoryPairs)));
    const double room = wanted / std::max(peak_, 1e-300);
    pair_tolerance_ = tolerance_ * std::clamp(kShare * room * room, kLeastShare, kMostShare);
    if (sim.state().t < end * (1.0 - 1e-12)) return;
    error_.max_position_m = std::max(error_.max_position_m, error_.position_m);
    if (error_.position_m <= tolerance_) return;
    if (!error_.lost_at_s) error_.lost_at_s = sim.state().t;
    companion_.restore(sim.state());
  }

  const double tolerance_, duration_;
  const double order_, power_;  // of the run's error in the step, and of a pair's
  const std::vector<double> corners_;
  std::vector<int> free_nodes_;
  Simulation companion_;
  FixedNumerics numerics_;
  StepAid aid_;
  State middle_;
  double next_pair_ = tolerance_ / kFirstSpeed;  // two steps together [s]
  double pair_tolerance_ = kShare * tolerance_;  // [m]
  double peak_ = 0.0;                            // of the error, as errors that swing are small now and then [m]
  ErrorEstimate error_;
};

}  // namespace

std::unique_ptr<StepControl> make_accurate_steps(const AccuracyNumerics& numerics, double duration_s,
                                                 const Simulation& sim, std::unique_ptr<LinearSolver> solver) {
  return std::make_unique<AccurateSteps>(numerics.tolerance_m, duration_s, sim, std::move(solver));
}

}  // namespace slipstitch
