// SPDX-License-Identifier: MIT
#include "worker/run_study_job.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "platform/blas.h"
#include "platform/memory.h"
#include "platform/version.h"
#include "report/number_text.h"
#include "run_dir/control_log.h"
#include "run_dir/throttle.h"
#include "scene_io/issue_text.h"
#include "scene_io/load_scene.h"
#include "scene_io/spec_hash.h"
#include "studies/run_study.h"
#include "studies/study_json.h"

namespace slipstitch {
namespace {

constexpr double kMostShare = 0.99;  // while it runs: how often the reference is refined shows only when it has been
constexpr double kProgressInterval_s = 0.5;  // at least, because what writes takes its time from runs that are timed

/// progress.json and control.log of a study.
class StudyDesk {
 public:
  StudyDesk(const RunDir& dir, const StudyWork& work, const RecorderOptions& options)
      : dir_(dir),
        work_(work),
        options_(options),
        control_(dir.control()),
        progress_due_(std::max(kProgressInterval_s, options.progress_interval_s)),
        control_due_(options.control_interval_s) {}

  void show(double share, const std::string& doing) {
    now_.share_done = std::max(now_.share_done, std::min(share, kMostShare));
    now_.doing = doing;
    if (progress_due_.due()) write();
  }

  /// Nothing is to go any more; `all`: as everything has been done.
  void finish(bool all) {
    ended_ = true;
    if (all) now_.share_done = 1.0;
    write();
  }

  bool should_stop() {
    if (!cancelled_ && control_due_.due())
      for (const std::string& command : control_.poll()) cancelled_ = cancelled_ || command == kCancelCommand;
    return cancelled_ || !error_.empty() || (options_.should_stop && options_.should_stop());
  }

  double wall_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  const IoError& error() const { return error_; }  // the first of writing progress

 private:
  void write() {
    now_.progress.wall_s = wall_s();
    now_.eta_s = eta();
    now_.update_time = utc_now();
    if (error_.empty()) error_ = write_progress(dir_, now_);
  }

  std::optional<double> eta() const {
    const double share = now_.share_done;
    if (ended_ || share <= 0.0) return std::nullopt;
    const double left = wall_s() * (1.0 - share) / share;
    return work_.budget_s > 0.0 ? std::min(left, std::max(0.0, work_.budget_s - wall_s())) : left;
  }

  const RunDir& dir_;
  const StudyWork& work_;
  const RecorderOptions& options_;
  ControlLogReader control_;
  Throttle progress_due_, control_due_;
  ProgressInfo now_;
  bool cancelled_ = false, ended_ = false;
  IoError error_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What makes another such study of the job's scene.json.
std::string command_of(const JobInfo& job) {
  std::string line = "slipstitch submit scene.json --study";
  if (job.study->quick) line += " --quick";
  if (job.study->budget_s > 0.0) line += " --budget " + short_number(job.study->budget_s, 9);
  return line + " --threads " + std::to_string(job.threads);
}

StudySummary failed(std::string message) {
  StudySummary summary;
  summary.message = std::move(message);
  return summary;
}

StudySummary summary_of(const StudyEnd& end, const IoError& error) {
  StudySummary summary = failed(error.empty() ? why_failed(end) : error);
  if (error.empty() && end.study.stopped) {
    summary.status = RunStatus::cancelled;
  } else if (summary.message.empty()) {
    summary.status = RunStatus::succeeded;
  }
  summary.study = study_json(end.study);
  return summary;
}

StudySummary study_stored_scene(const RunDir& dir, const JobInfo& job, StudyDesk& desk) {
  const Result<std::string> text = read_scene(dir);
  if (!text) return failed(text.error);
  LoadResult loaded = load_scene_json(*text);
  if (const auto* issues = std::get_if<Issues>(&loaded)) return failed(issue_lines(*issues));
  LoadedScene& scene = std::get<LoadedScene>(loaded);
  StudyDir runs(dir.study(), {message_hash(scene.message), scene.scene.name, version_string(), to_string(blas_in_use()),
                              job.threads});
  if (const IoError error = runs.prepare(); !error.empty()) return failed(error);
  if (scene.scene.name.empty()) scene.scene.name = "scene";
  StudyOrder order;
  order.work = *job.study;
  order.threads = job.threads;
  order.report = dir.report();
  order.command = command_of(job);
  order.job = job.name;
  order.on_progress = [&desk](double share, const std::string& doing) { desk.show(share, doing); };
  order.should_stop = [&desk] { return desk.should_stop(); };
  return summary_of(run_study(std::move(scene.scene), runs, order), desk.error());
}

RunSummary in_short(const StudySummary& summary) {
  RunSummary result;
  result.status = summary.status;
  result.message = summary.message;
  result.scene = summary.scene;
  result.threads = summary.threads;
  result.wall_s = summary.wall_s;
  result.blas = summary.blas;
  result.version = summary.version;
  result.peak_memory_bytes = summary.peak_memory_bytes;
  return result;
}

}  // namespace

Result<RunSummary> run_study_job(const RunDir& dir, const JobInfo& job, const RecorderOptions& options) {
  StudyDesk desk(dir, *job.study, options);
  desk.show(0.0, "starting");
  StudySummary summary = study_stored_scene(dir, job, desk);
  desk.finish(summary.status == RunStatus::succeeded);
  summary.scene = job.scene_name;
  summary.threads = job.threads;
  summary.wall_s = desk.wall_s();
  summary.blas = to_string(blas_in_use());
  summary.version = version_string();
  summary.peak_memory_bytes = peak_memory_bytes();
  if (IoError error = write_summary(dir, summary); !error.empty()) return Result<RunSummary>::failed(std::move(error));
  return Result<RunSummary>::of(in_short(summary));
}

}  // namespace slipstitch
