// SPDX-License-Identifier: MIT
#include "jobs/job_record.h"

#include <sys/stat.h>

#include <algorithm>

#include "jobs/server_summary.h"
#include "run_dir/atomic_file.h"
#include "run_dir/control_log.h"
#include "run_dir/frame_log.h"

namespace slipstitch::jobs {
namespace {

constexpr std::size_t kMaxSummaryBytes = 1 << 18;

JobState state_of(RunStatus status) {
  switch (status) {
    case RunStatus::succeeded:
      return JobState::succeeded;
    case RunStatus::cancelled:
      return JobState::cancelled;
    case RunStatus::failed:
      break;
  }
  return JobState::failed;
}

bool cancel_was_requested(const RunDir& dir) {
  for (const std::string& command : ControlLogReader(dir.control()).poll()) {
    if (command == kCancelCommand) return true;
  }
  return false;
}

// A worker that was killed had no time to write its last progress.json.
void count_logged_frames(const RunDir& dir, Progress& progress) {
  FrameLogReader log(dir.frames());
  log.poll();
  progress.frames = std::max(progress.frames, log.num_frames());
}

void take_summary(JobRecord& record) {
  Job& job = record.job;
  const Result<std::string> text = read_file(record.dir.summary(), kMaxSummaryBytes);
  const std::optional<ServerSummary> summary = text ? parse_summary(*text) : std::nullopt;
  job.state = summary ? state_of(summary->status) : JobState::failed;
  job.summary_json = summary ? *text : std::string();
  // Files are stamped by a clock that lags a tick behind utc_now(); RFC 3339 sorts as text.
  job.end_time = std::max({file_time(record.dir.summary()), job.start_time, job.info.create_time});
  if (job.state != JobState::failed) return;
  if (job.progress) count_logged_frames(record.dir, job.progress->progress);
  job.failure =
      summary ? summary->failure : Failure{"STORAGE_FAILED", record.dir.summary().string() + " cannot be read", {}};
}

void end_with(JobRecord& record, RunStatus status, const Failure& failure) {
  const std::string text = server_summary(status, record.job.info.scene_name, failure);
  const IoError error = write_file_atomic(record.dir.summary(), text);
  take_summary(record);
  if (!error.empty()) record.job.failure = Failure{"STORAGE_FAILED", error, {}};
}

}  // namespace

FileStamp stamp_of(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_ino, static_cast<std::uint64_t>(status.st_size),
          std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

Result<JobRecord> load_job(const RunDir& dir, const std::string& id) {
  Result<JobInfo> info = read_job(dir);
  if (!info) return Result<JobRecord>::failed(info.error);
  JobRecord record;
  record.job.id = id;
  record.job.info = std::move(*info);
  record.job.cancel_requested = cancel_was_requested(dir);
  record.dir = dir;
  bool frames_grew = false;
  refresh_progress(record, frames_grew);
  if (const Result<WorkerInfo> worker = read_worker(dir); worker) {
    record.worker = *worker;
    record.job.state = JobState::running;
    record.job.start_time = std::max(file_time(dir.worker()), record.job.info.create_time);
    if (!worker_alive(*worker)) settle(record, {});
  } else if (has_summary(dir)) {
    take_summary(record);
  }
  return Result<JobRecord>::of(std::move(record));
}

bool refresh_progress(JobRecord& record, bool& frames_grew) {
  const FileStamp frames = stamp_of(record.dir.frames());
  frames_grew = frames != record.frames;
  record.frames = frames;
  const FileStamp progress = stamp_of(record.dir.progress());
  if (progress == record.progress) return false;
  record.progress = progress;
  const Result<ProgressInfo> info = read_progress(record.dir);
  if (info) record.job.progress = *info;
  return static_cast<bool>(info);
}

void settle(JobRecord& record, const WorkerEnd& end) {
  bool frames_grew = false;
  refresh_progress(record, frames_grew);
  if (has_summary(record.dir)) return take_summary(record);
  end_with(record, RunStatus::failed, failure_of(end, record.dir));
}

void settle_cancelled(JobRecord& record) { end_with(record, RunStatus::cancelled, {}); }

void settle_failed(JobRecord& record, Failure failure) { end_with(record, RunStatus::failed, failure); }

}  // namespace slipstitch::jobs
