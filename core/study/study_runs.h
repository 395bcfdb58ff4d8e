// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "study/work_precision.h"

namespace slipstitch {

/// One run of a study.
struct StudyRun {
  Scene scene;
  std::string key;     // on the shelf
  std::string what;    // for people
  double work = 0.0;   // about, in solves; what progress is measured in
  bool noise = false;  // at the start, as of the reference's twin
};
StudyRun study_run(const Scene& scene, const Rung& rung, bool noise = false);

/// Runs for a study: what is on the shelf is not run again. Ends when it is asked to, or when the shelf fails.
class StudyRuns {
 public:
  explicit StudyRuns(const WorkPrecisionOptions& options);

  /// From the shelf only.
  std::optional<KeptRun> find(const StudyRun& run) { return shelf_->find(run.key); }
  /// From the shelf, or run now. Nothing: ended(), or the time has come.
  std::optional<KeptRun> get(const StudyRun& run, double until_s);
  /// Once more, for its time; false as above.
  bool again(const StudyRun& run, double until_s);

  void plan(double work) { planned_ += work; }
  double now() const { return clock_() - start_; }  // since the study began [s]
  bool fits(double wall_s, double until_s) const { return now() + wall_s <= until_s; }
  bool ended() const { return stopped_ || !failure_.empty(); }
  bool stopped() const { return stopped_; }
  const std::string& failure() const { return failure_; }

 private:
  std::optional<KeptRun> run(const StudyRun& run, double until_s);
  bool keep(const StudyRun& run, const KeptRun& kept);
  bool asked_to_stop();

  const WorkPrecisionOptions& options_;
  std::unique_ptr<RunShelf> own_shelf_;
  RunShelf* shelf_;
  std::function<double()> clock_;
  double start_ = 0.0, planned_ = 0.0, done_ = 0.0, shown_ = 0.0;
  bool stopped_ = false;
  std::string failure_;
};

}  // namespace slipstitch
