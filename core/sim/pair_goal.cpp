// SPDX-License-Identifier: MIT
#include "sim/pair_goal.h"

#include <algorithm>
#include <cmath>

#include "sim/cost_course.h"

namespace slipstitch {
namespace {

constexpr double kMemory = 0.1;                                        // of the duration, for peaks of the error,
constexpr double kMemoryPairs = 20.0;                                  // but not of more pairs
constexpr double kWantedAtEnd = 0.35;                                  // of the tolerance, that the error is steered to
constexpr double kWantedAtStart = 0.2;                                 // of that
constexpr double kShare = 0.05, kLeastShare = 2e-3, kMostShare = 0.1;  // of the tolerance, for one pair

constexpr double kLoosestRadii = 10.0;  // tolerance
constexpr double kUsualRadii = 0.01;    // that a pair as long as from frame to frame is off by in calm motion
constexpr double kTrialShare = 0.1;     // of the time that is left
constexpr double kReserve = 0.02;       // of the budget, for what comes after the last step
constexpr double kTighten = 1.0 / 3.0, kLoosen = 10.0;  // at most, from one pair to the next
constexpr double kPriorShare = 0.05;                    // of the budget, that what was foreseen is worth to begin with
constexpr double kCostMemory = 0.1;       // of the budget, for how what was foreseen compares with what it took,
constexpr double kCostMemoryPairs = 3.0;  // but not of fewer pairs
constexpr double kLeastRatio = 1e-3, kMostRatio = 30.0;  // of that
constexpr double kStart = 0.02;  // of the duration, in which steps begin short whatever the tolerance
constexpr double kFelt = 0.1;    // of its tolerance: a smaller error did not set the length of the pair

/// How large the run's error was lately, as errors that swing are small now and then, and what it may come to.
class ErrorCourse {
 public:
  explicit ErrorCourse(double duration_s) : duration_(duration_s) {}
  void pass(const PairDone& done) {
    way_ = kWantedAtStart + (1.0 - kWantedAtStart) * done.end_s / duration_;
    const double pairs = std::max(done.length_s / (kMemory * duration_), 1.0 / kMemoryPairs);
    peak_ = std::max(done.run_error_m, peak_ * std::exp(-pairs));
  }
  double pair_tolerance(double tolerance_m) const {
    const double wanted = kWantedAtEnd * tolerance_m * way_;
    const double room = wanted / std::max(peak_, 1e-300);
    return tolerance_m * std::clamp(kShare * room * room, kLeastShare, kMostShare);
  }
  /// The tolerance with this pair_tolerance().
  double tolerance(double pair_tolerance_m) const {
    double low = pair_tolerance_m / kMostShare, high = pair_tolerance_m / kLeastShare;
    for (int i = 0; i < 20; ++i) {
      const double middle = std::sqrt(low * high);
      (pair_tolerance(middle) < pair_tolerance_m ? low : high) = middle;
    }
    return std::sqrt(low * high);
  }

 private:
  const double duration_;
  double peak_ = 0.0, way_ = kWantedAtStart;
};

class ToleranceGoal final : public PairGoal {
 public:
  ToleranceGoal(double tolerance_m, double duration_s)
      : tolerance_(tolerance_m), pair_tolerance_(kShare * tolerance_m), error_(duration_s) {}
  double pair_tolerance_m() const override { return pair_tolerance_; }
  double tolerance_m() const override { return tolerance_; }
  double lost_m() const override { return tolerance_; }
  void learn(const PairDone& done) override {
    error_.pass(done);
    pair_tolerance_ = error_.pair_tolerance(tolerance_);
  }

 private:
  const double tolerance_;
  double pair_tolerance_;
  ErrorCourse error_;
};

class BudgetGoal final : public PairGoal {
 public:
  BudgetGoal(double budget_s, const Scene& scene, const RunClock& clock)
      : budget_(budget_s),
        duration_(scene.duration_s),
        frame_s_(1.0 / scene.frames_per_s),
        loosest_(kMostShare * loosest_tolerance_m(scene.yarn.radius_m)),
        clock_(clock),
        last_s_(clock.wall_s()),
        trial_until_s_(last_s_ + kTrialShare * (budget_s - last_s_)),
        course_(scene.duration_s, kUsualRadii * scene.yarn.radius_m),
        error_(scene.duration_s),
        foreseen_(kPriorShare * budget_s),
        taken_(foreseen_),
        pair_tolerance_(loosest_) {}

  double pair_tolerance_m() const override { return pair_tolerance_; }
  double tolerance_m() const override { return pair_tolerance_ / kMostShare; }
  double lost_m() const override { return loosest_ / kMostShare; }

  bool jumps() const override { return true; }
  bool on_trial() const override { return trial_ && clock_.wall_s() < trial_until_s_; }
  void end_trial() override {
    trial_ = false;
    last_s_ = clock_.wall_s();
    pair_tolerance_ = fitting(0.0, last_s_);
  }

  void learn(const PairDone& done) override {
    const double now = clock_.wall_s(), wall = now - last_s_;
    last_s_ = now;
    const double error = done.error_m < kFelt * pair_tolerance_ ? done.error_m : pair_tolerance_;
    CostCourse::Pair pair{done.end_s - done.length_s, done.end_s, wall, error, 1.0};
    if (trial_) return course_.add(pair);
    // Steps that are still growing to their length say nothing.
    if (pair.begin_s >= kStart * duration_ || done.error_m >= kFelt * pair_tolerance_) compare(pair);
    note(done, wall);
    if (done.end_s > known_until_s()) {  // where the trial did not come to
      pair.wall_s /= ratio();
      pair.least_share = std::min(1.0, done.length_s / frame_s_);
      course_.add(pair);
    }
    const double fits = fitting(done.end_s, now);
    const bool late = now > budget_;
    pair_tolerance_ = late ? loosest_ : std::clamp(fits, kTighten * pair_tolerance_, kLoosen * pair_tolerance_);
  }

  std::optional<BudgetReport> budget() const override {
    BudgetReport report;
    report.budget_s = budget_;
    if (taken_all_ > 0.0) report.same_tolerance_m = std::exp(log_tolerance_ / taken_all_);
    report.loosest_tolerance_m = loosest_ / kMostShare;
    report.share_at_loosest = duration_ > 0.0 ? std::min(1.0, at_loosest_s_ / duration_) : 0.0;
    return report;
  }

 private:
  double known_until_s() const { return course_.known_until_s() + 1e-9 * duration_; }
  /// What pairs take against what was foreseen, lately.
  double ratio() const { return std::clamp(taken_ / foreseen_, kLeastRatio, kMostRatio); }

  void compare(const CostCourse::Pair& pair) {
    const double foreseen = course_.wall_s(pair.begin_s, pair.end_s, pair_tolerance_);
    if (foreseen <= 0.0) return;
    const double passed = std::max(pair.wall_s, foreseen) / (kCostMemory * budget_);
    const double kept = std::exp(-std::min(passed, 1.0 / kCostMemoryPairs));
    taken_ = kept * taken_ + pair.wall_s;
    foreseen_ = kept * foreseen_ + foreseen;
  }

  /// For the report. Tolerances count by the time that was spent at them.
  void note(const PairDone& done, double wall) {
    error_.pass(done);
    taken_all_ += wall;
    log_tolerance_ += wall * std::log(error_.tolerance(pair_tolerance_));
    if (pair_tolerance_ >= loosest_) at_loosest_s_ += done.length_s;
  }

  /// The pair tolerance with which the time that is left is enough from here on.
  double fitting(double t, double now) const {
    if (course_.known_until_s() <= 0.0) return loosest_;
    const double left = (1.0 - kReserve) * budget_ - now;
    const auto fits = [&](double tolerance) { return ratio() * course_.wall_s(t, duration_, tolerance) <= left; };
    double fine = kMostShare * AccuracyNumerics::kLeastTolerance_m, coarse = loosest_;
    if (!fits(coarse)) return coarse;
    for (int i = 0; i < 30; ++i) {
      const double middle = std::sqrt(fine * coarse);
      (fits(middle) ? coarse : fine) = middle;
    }
    return coarse;
  }

  const double budget_, duration_, frame_s_;
  const double loosest_;  // pair tolerance [m]
  const RunClock clock_;
  double last_s_;  // wall time at the end of the last pair
  const double trial_until_s_;
  bool trial_ = true;
  CostCourse course_;
  ErrorCourse error_;
  double foreseen_, taken_;  // of wall time, by pairs [s]
  double pair_tolerance_;
  double taken_all_ = 0.0, log_tolerance_ = 0.0, at_loosest_s_ = 0.0;
};

}  // namespace

std::unique_ptr<PairGoal> make_tolerance_goal(const AccuracyNumerics& numerics, double duration_s) {
  return std::make_unique<ToleranceGoal>(numerics.tolerance_m, duration_s);
}

double loosest_tolerance_m(double yarn_radius_m) {
  return std::max(kLoosestRadii * yarn_radius_m, AccuracyNumerics::kLeastTolerance_m);
}

std::unique_ptr<PairGoal> make_budget_goal(const BudgetNumerics& numerics, const Scene& scene, const RunClock& clock) {
  return std::make_unique<BudgetGoal>(numerics.budget_s, scene, clock);
}

}  // namespace slipstitch
